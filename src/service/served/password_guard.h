// Whoever guesses passwords: those of an address are looked at one after the other, and each wrong
// one of the last minute makes the next one wait longer. The right one always has its turn; other
// addresses notice nothing. Time is an argument.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <string>

namespace merker::served {

class PasswordGuard {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::size_t kMostAddresses = 1024;  // remembered; beyond that nobody may try
  static constexpr std::chrono::milliseconds kStep{100};
  static constexpr std::chrono::seconds kLongestWait{30};

  // How long a password of this address has to wait; nothing: too many of them wait already.
  std::optional<Time::duration> turn(const std::string& address, Time now);
  void wrong(const std::string& address, Time now);

 private:
  struct One {
    std::deque<Time> wrong{};  // of the last minute
    Time next{};               // when the next one has its turn
  };
  void forget(Time now);
  std::map<std::string, One> addresses_;
};

}  // namespace merker::served
