#include "s7comm/outlet.h"

#include <utility>

namespace merker::s7comm {

bool Outlet::send(Indication one) {
  const std::lock_guard lock(mutex_);
  const bool good = !closed_ && waiting_.size() < kMostWaiting && one.octets.size() <= room_;
  if (good)
    waiting_.push_back(std::move(one));
  else
    ++lost_;
  return good;
}

bool Outlet::announce() {
  const std::lock_guard lock(mutex_);
  return !waiting_.empty() && !announced_.exchange(true);
}

void Outlet::deliver() {
  announced_ = false;
  std::function<void()> call;
  {
    const std::lock_guard lock(mutex_);
    call = deliver_;
  }
  if (call) call();
}

std::optional<Indication> Outlet::take() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  Indication one = std::move(waiting_.front());
  waiting_.pop_front();
  return one;
}

void Outlet::close() {
  const std::lock_guard lock(mutex_);
  deliver_ = nullptr;
  closed_ = true;
  waiting_.clear();
}

}  // namespace merker::s7comm
