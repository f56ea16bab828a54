#pragma once
// Work that is shared out among threads.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace rayscope::exercises {

/// 0: as many as there are processors.
[[nodiscard]] inline int threads_for(int jobs) {
    return jobs > 0 ? jobs : std::max(1, int(std::thread::hardware_concurrency()));
}

/// work(i) for each i < count, by several threads. The first exception is thrown again when all have ended.
template <typename Work> void in_parallel(std::size_t count, int jobs, const Work& work) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr problem;
    std::mutex guard;
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(guard);
                if (!problem) problem = std::current_exception();
                next = count;
            }
        }
    };
    std::vector<std::jthread> threads;
    for (int i = 1; i < threads_for(jobs); ++i) threads.emplace_back(run);
    run();
    threads.clear();
    if (problem) std::rethrow_exception(problem);
}

} // namespace rayscope::exercises
