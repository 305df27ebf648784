#include "served/password_guard.h"

namespace merker::served {

void PasswordGuard::forget(Time now) {
  for (auto& [address, times] : wrong_)
    while (!times.empty() && now - times.front() >= std::chrono::minutes(1)) times.pop_front();
  std::erase_if(wrong_, [](const auto& one) { return one.second.empty(); });
}

bool PasswordGuard::mayTry(const std::string& address, Time now) {
  forget(now);
  const auto found = wrong_.find(address);
  if (found == wrong_.end()) return wrong_.size() < kMostAddresses;
  return found->second.size() < kMostWrong;
}

std::chrono::milliseconds PasswordGuard::wrong(const std::string& address, Time now) {
  forget(now);
  auto& times = wrong_[address];
  times.push_back(now);
  return kStep * times.size();
}

}  // namespace merker::served
