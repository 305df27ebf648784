// Ends the pause of a thread.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace merker::app {

class Bell {
 public:
  // From any thread; one that nobody waits for ends the next pause.
  void ring() {
    const std::lock_guard lock(mutex_);
    rung_ = true;
    ringing_.notify_one();
  }

  void wait(std::chrono::nanoseconds longest) {
    std::unique_lock lock(mutex_);
    ringing_.wait_for(lock, longest, [this] { return rung_; });
    rung_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable ringing_;
  bool rung_ = false;
};

}  // namespace merker::app
