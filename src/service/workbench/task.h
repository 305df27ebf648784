// Work that is carried out elsewhere while the PLC goes on: it looks at copies only.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>

namespace merker::workbench {

class Task {
 public:
  using Run = std::function<void(const std::stop_token&)>;

  // `owner`: the browser it is for; workers serve them in turn.
  Task(std::uint64_t owner, Run run) : owner_(owner), run_(std::move(run)) {}

  std::uint64_t owner() const { return owner_; }
  // Once, in the thread of the worker; nothing if it was cancelled.
  void carryOut();
  // What has not begun never will, and lets go of what it holds; what has begun is asked to end.
  void cancel();
  bool cancelled() const { return stop_.stop_requested(); }
  bool done() const { return done_.load(std::memory_order_acquire); }
  // When it is done: it was cancelled, or there was not enough memory for it.
  bool failed() const { return failed_; }

 private:
  Run take();

  std::uint64_t owner_;
  std::mutex mutex_;
  Run run_;
  std::stop_source stop_;
  bool failed_ = false;
  std::atomic<bool> done_ = false;
};

using Work = std::shared_ptr<Task>;
// Who carries work out, some time and in some thread; one after the other.
using Worker = std::function<void(Work)>;

}  // namespace merker::workbench
