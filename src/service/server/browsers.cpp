#include "server/browsers.h"

namespace merker::hmi {

BrowserId Browsers::add(const std::shared_ptr<Connection>& connection) {
  const std::lock_guard lock(mutex_);
  if (open_.size() >= most_) return 0;
  open_[++last_] = {connection, connection->waiting};
  return last_;
}

void Browsers::remove(BrowserId id) {
  const std::lock_guard lock(mutex_);
  open_.erase(id);
}

std::shared_ptr<Connection> Browsers::find(BrowserId id) const {
  const std::lock_guard lock(mutex_);
  const auto found = open_.find(id);
  return found == open_.end() ? nullptr : found->second.connection.lock();
}

std::shared_ptr<std::atomic<std::size_t>> Browsers::waiting(BrowserId id) const {
  const std::lock_guard lock(mutex_);
  const auto found = open_.find(id);
  return found == open_.end() ? nullptr : found->second.waiting;
}

std::vector<std::shared_ptr<Connection>> Browsers::all() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<Connection>> list;
  for (const auto& [id, open] : open_)
    if (auto alive = open.connection.lock()) list.push_back(std::move(alive));
  return list;
}

}  // namespace merker::hmi
