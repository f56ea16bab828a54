#include "core/tracer/render.hpp"

#include "core/extents/scan.hpp"
#include "core/tracer/tracer.hpp"

#include <chrono>
#include <ctime>
#include <mutex>
#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace rayscope {
namespace {

constexpr int tile = 16; // pixels a side: small enough to share out evenly, large enough to cost nothing

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// Tells the caller how far the render is, a hundred times at most.
class Progress {
public:
    Progress(const std::function<void(double)>& report, int rows) : report_(report), total_(rows) {}
    void add(int pixels) {
        if (!report_) return;
        const std::lock_guard lock(mutex_);
        done_ += pixels;
        if (done_ * 100 / total_ == told_) return;
        told_ = done_ * 100 / total_;
        report_(double(done_) / double(total_));
    }

private:
    const std::function<void(double)>& report_;
    std::mutex mutex_;
    std::int64_t total_, done_ = 0, told_ = -1;
};

} // namespace

RenderResult render(const World<double>& world, const Camera& camera, const RenderOptions& options) {
    const int width = options.width > 0 ? options.width : camera.width;
    const int height = options.height > 0 ? options.height : camera.height;
    RenderResult result{Image(width, height), {}, true};
    const EyeRays eye_rays(camera, width, height);

    const auto wall_start = std::chrono::steady_clock::now();
    const double cpu_start = cpu_seconds();
    const Scan<double> stage(world);
    tbb::enumerable_thread_specific<Work<double>> works;
    Progress progress(options.progress, width * height);
    std::atomic<bool> complete = true;
    // What fork and join guarantee, once more where ThreadSanitizer, which can't see into TBB, finds it.
    std::atomic<int> begun = 0, finished = 0;
    begun.store(1, std::memory_order_release);

    const auto render_tile = [&](const tbb::blocked_range2d<int>& pixels) {
        (void)begun.load(std::memory_order_acquire);
        if (options.stop != nullptr && options.stop->load(std::memory_order_relaxed)) {
            complete = false;
            return;
        }
        NullRecorder recorder;
        Tracer tracer(world, stage, works.local(), recorder);
        for (int y = pixels.rows().begin(); y < pixels.rows().end(); ++y)
            for (int x = pixels.cols().begin(); x < pixels.cols().end(); ++x)
                result.image.set(x, y, tracer.trace(eye_rays.through(x + 0.5, y + 0.5)));
        progress.add(int(pixels.rows().size() * pixels.cols().size()));
        finished.fetch_add(1, std::memory_order_release);
    };
    const auto threads = options.threads > 0 ? options.threads : tbb::task_arena::automatic;
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(std::max(1, tbb::task_arena(threads).max_concurrency())));
    tbb::task_arena(threads).execute([&] {
        tbb::parallel_for(tbb::blocked_range2d<int>(0, height, tile, 0, width, tile), render_tile,
                          tbb::simple_partitioner());
    });
    (void)finished.load(std::memory_order_acquire);

    for (const Work<double>& work : works) result.statistics.counters += work.counters;
    result.statistics.cpu_seconds = cpu_seconds() - cpu_start;
    result.statistics.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
    result.complete = complete;
    return result;
}

Recording record(const World<double>& world, const Ray<double>& ray) {
    const Scan<double> stage(world);
    Work<double> work;
    TraceRecorder recorder;
    Tracer tracer(world, stage, work, recorder);
    const Colour colour = tracer.trace(ray);
    return {recorder.take(), colour, recorder.dropped()};
}

} // namespace rayscope
