#include "served/password_guard.h"

#include <algorithm>

namespace merker::served {

void PasswordGuard::forget(Time now) {
  for (auto& [address, one] : addresses_)
    while (!one.wrong.empty() && now - one.wrong.front() >= std::chrono::minutes(1))
      one.wrong.pop_front();
  std::erase_if(addresses_, [now](const auto& entry) {
    return entry.second.wrong.empty() && entry.second.next <= now;
  });
}

std::optional<PasswordGuard::Time::duration> PasswordGuard::turn(const std::string& address,
                                                                 Time now) {
  forget(now);
  if (!addresses_.contains(address) && addresses_.size() >= kMostAddresses) return std::nullopt;
  One& one = addresses_[address];
  const Time begin = std::max(now, one.next);
  if (begin - now > kLongestWait) return std::nullopt;
  one.next = begin + kStep * (one.wrong.size() + 1);
  return begin - now;
}

void PasswordGuard::wrong(const std::string& address, Time now) {
  forget(now);
  addresses_[address].wrong.push_back(now);
}

}  // namespace merker::served
