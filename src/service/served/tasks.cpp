#include "served/tasks.h"

#include <algorithm>

namespace merker::served {

// Those that begin meanwhile run the next time.
void Tasks::run(monitor::Monitor& monitor, const Post& post) {
  if (tasks_.empty()) return;
  const auto running = tasks_;
  for (const auto& task : running) {
    const bool goesOn = !task->client_->isClosed() && task->run(monitor);
    if (task->client_->announce()) post([client = task->client_] { client->deliver(); });
    if (!goesOn) remove(*task, monitor);
  }
}

void Tasks::remove(const Task& task, monitor::Monitor& monitor) {
  const auto found =
      std::ranges::find(tasks_, &task, [](const auto& one) { return std::to_address(one); });
  if (found == tasks_.end()) return;
  const auto kept = *found;
  tasks_.erase(found);
  kept->end(monitor);
}

void Tasks::clear(monitor::Monitor& monitor) {
  for (const auto& task : std::exchange(tasks_, {})) task->end(monitor);
}

}  // namespace merker::served
