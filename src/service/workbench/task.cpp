#include "workbench/task.h"

#include <exception>
#include <utility>

namespace merker::workbench {

Task::Run Task::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(run_, nullptr);
}

// The work is destroyed before it counts as done: what it held is freed here, not in the PLC's
// thread.
void Task::carryOut() {
  try {
    if (const Run run = take())
      run(stop_.get_token());
    else
      failed_ = true;
  } catch (const std::exception&) {
    failed_ = true;
  }
  if (stop_.stop_requested()) failed_ = true;
  done_.store(true, std::memory_order_release);
}

void Task::cancel() {
  stop_.request_stop();
  static_cast<void>(take());
}

}  // namespace merker::workbench
