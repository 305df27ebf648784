// Whoever guesses passwords: each wrong one makes the next answers from its address later, and so
// many within a minute end it. Others notice nothing. Time is an argument.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <string>

namespace merker::served {

class PasswordGuard {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::size_t kMostWrong = 10;        // a minute, of an address
  static constexpr std::size_t kMostAddresses = 1024;  // remembered; beyond that nobody may try
  static constexpr std::chrono::milliseconds kStep{100};

  bool mayTry(const std::string& address, Time now);
  // How long the answer to this wrong one is to wait.
  std::chrono::milliseconds wrong(const std::string& address, Time now);

 private:
  void forget(Time now);
  std::map<std::string, std::deque<Time>> wrong_;  // of the last minute
};

}  // namespace merker::served
