#include "visualizer/window/worker.hpp"

#include <QMetaObject>
#include <QObject>

namespace rayscope::window {

Worker::Worker(QObject* home) : home_(home), thread_([this] { loop(); }) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        waiting_ = nullptr;
        stop_ = true;
        ++newest_;
    }
    wake_.notify_one();
    thread_.join();
}

void Worker::run(Job job) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(job);
        ++newest_;
        stop_ = true;
        busy_ = true;
    }
    wake_.notify_one();
}

void Worker::hand_over(std::function<void()> show) {
    const unsigned made_by = running_;
    QMetaObject::invokeMethod(
        home_,
        [this, made_by, show = std::move(show)] {
            if (made_by == newest_) show();
        },
        Qt::QueuedConnection);
}

void Worker::loop() {
    for (;;) {
        Job job;
        {
            std::unique_lock lock(mutex_);
            busy_ = waiting_ != nullptr;
            wake_.wait(lock, [this] { return ended_ || waiting_ != nullptr; });
            if (ended_) return;
            job = std::move(waiting_);
            waiting_ = nullptr;
            running_ = newest_;
            stop_ = false;
        }
        job(stop_);
    }
}

} // namespace rayscope::window
