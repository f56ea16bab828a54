#include "core/tracer/tiles.hpp"

#include "core/tracer/tile_task.hpp"

#include <chrono>
#include <ctime>
#include <mutex>
#include <tbb/blocked_range2d.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace rayscope {
namespace {

constexpr int side =
    16; // of a tile, in pixels: small enough to share out evenly, large enough to cost nothing

double cpu_time() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) / 1e9;
}

double wall_time() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
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
    Renderer(int width, int height, const RenderOptions& options,
             const std::function<void(const Tile&)>& work)
        : width_(width),
          height_(height),
          options_(options),
          work_(work),
          progress_(options.progress, std::int64_t(width) * height) {}

    [[nodiscard]] bool run() {
        threads_.fork();
        const tbb::blocked_range2d<int> pixels(0, height_, side, 0, width_, side);
        tbb::task_arena arena(options_.threads > 0 ? options_.threads : tbb::task_arena::automatic);
        const tbb::global_control allow(tbb::global_control::max_allowed_parallelism,
                                        std::size_t(std::max(1, arena.max_concurrency())));
        arena.execute([&] { tbb::parallel_for(pixels, tile_task(*this), tbb::simple_partitioner()); });
        threads_.join();
        return complete_;
    }

    void render_tile(const tbb::blocked_range2d<int>& pixels) {
        threads_.enter();
        if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
            complete_ = false;
            return;
        }
        work_({pixels.cols().begin(), pixels.rows().begin(), pixels.cols().end(), pixels.rows().end()});
        progress_.add(int(pixels.rows().size() * pixels.cols().size()));
        threads_.leave();
    }

private:
    int width_, height_;
    const RenderOptions& options_;
    const std::function<void(const Tile&)>& work_;
    Progress progress_;
    std::atomic<bool> complete_ = true;
    ForkAndJoin threads_;
};

} // namespace

bool for_each_tile(int width, int height, const RenderOptions& options,
                   const std::function<void(const Tile&)>& work) {
    return Renderer(width, height, options, work).run();
}

Stopwatch::Stopwatch() : cpu_start_(cpu_time()), wall_start_(wall_time()) {}
double Stopwatch::cpu_seconds() const { return cpu_time() - cpu_start_; }
double Stopwatch::wall_seconds() const { return wall_time() - wall_start_; }

} // namespace rayscope
