#pragma once
// Work beside the window: one thread, and only the newest job counts.

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

class QObject;

namespace rayscope::window {

class Worker {
public:
    /// Its `stop` becomes true when another job was given: what it makes is not wanted any more.
    using Job = std::function<void(const std::atomic<bool>& stop)>;

    /// @param home whose thread is the window's; results are handed over there
    explicit Worker(QObject* home);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Takes the place of the job that runs or waits. Returns at once.
    void run(Job job);
    /// Called from a job: carries out `show` in the window's thread, unless another job was given by then.
    void hand_over(std::function<void()> show);
    /// Whether a job runs or waits.
    [[nodiscard]] bool busy() const { return busy_; }

private:
    void loop();

    QObject* home_;
    std::mutex mutex_;
    std::condition_variable wake_;
    Job waiting_;
    std::atomic<bool> stop_{false}, busy_{false};
    bool ended_ = false;
    std::atomic<unsigned> newest_{0}; // counts the jobs given
    unsigned running_ = 0;            // … which of them runs; the thread's own
    std::thread thread_;
};

} // namespace rayscope::window
