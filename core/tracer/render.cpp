#include "core/tracer/render.hpp"

#include "core/extents/scan.hpp"
#include "core/tracer/tile_task.hpp"
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
    Progress(const std::function<void(double)>& report, std::int64_t pixels)
        : report_(report), total_(pixels) {}
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

// What TBB's fork and join guarantee, said once more where ThreadSanitizer, which can't see into TBB, finds it.
class ForkAndJoin {
public:
    void fork() { forked_.store(true, std::memory_order_release); }
    void enter() const { (void)forked_.load(std::memory_order_acquire); }
    void leave() { left_.fetch_add(1, std::memory_order_release); }
    void join() const { (void)left_.load(std::memory_order_acquire); }

private:
    std::atomic<bool> forked_ = false;
    std::atomic<int> left_ = 0;
};

class Renderer {
public:
    Renderer(const World<double>& world, const Camera& camera, const RenderOptions& options, Image& image)
        : world_(world),
          options_(options),
          image_(image),
          stage_(world),
          eye_rays_(camera, image.width, image.height),
          progress_(options.progress, std::int64_t(image.width) * image.height) {}

    void run();
    void render_tile(const tbb::blocked_range2d<int>& pixels);

    [[nodiscard]] bool complete() const { return complete_; }
    [[nodiscard]] Counters counters() const {
        Counters sum;
        for (const Work<double>& work : works_) sum += work.counters;
        return sum;
    }

private:
    const World<double>& world_;
    const RenderOptions& options_;
    Image& image_;
    Scan<double> stage_;
    EyeRays eye_rays_;
    Progress progress_;
    tbb::enumerable_thread_specific<Work<double>> works_;
    std::atomic<bool> complete_ = true;
    ForkAndJoin threads_;
};

void Renderer::run() {
    threads_.fork();
    const tbb::blocked_range2d<int> pixels(0, image_.height, tile, 0, image_.width, tile);
    tbb::task_arena arena(options_.threads > 0 ? options_.threads : tbb::task_arena::automatic);
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(std::max(1, arena.max_concurrency())));
    arena.execute([&] { tbb::parallel_for(pixels, tile_task(*this), tbb::simple_partitioner()); });
    threads_.join();
}

void Renderer::render_tile(const tbb::blocked_range2d<int>& pixels) {
    threads_.enter();
    if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
        complete_ = false;
        return;
    }
    NullRecorder recorder;
    Tracer tracer(world_, stage_, works_.local(), recorder);
    for (int y = pixels.rows().begin(); y < pixels.rows().end(); ++y)
        for (int x = pixels.cols().begin(); x < pixels.cols().end(); ++x)
            image_.set(x, y, tracer.trace(eye_rays_.through(x + 0.5, y + 0.5)));
    progress_.add(int(pixels.rows().size() * pixels.cols().size()));
    threads_.leave();
}

} // namespace

RenderResult render(const World<double>& world, const Camera& camera, const RenderOptions& options) {
    RenderResult result;
    result.image = Image(options.width > 0 ? options.width : camera.width,
                         options.height > 0 ? options.height : camera.height);
    const auto wall_start = std::chrono::steady_clock::now();
    const double cpu_start = cpu_seconds();
    Renderer renderer(world, camera, options, result.image);
    renderer.run();
    result.complete = renderer.complete();
    result.statistics.counters = renderer.counters();
    result.statistics.cpu_seconds = cpu_seconds() - cpu_start;
    result.statistics.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
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
