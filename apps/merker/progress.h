// How far long work has come, on a terminal only: a line on standard error that is wiped out at the
// end.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace merker::app {

class Progress {
 public:
  explicit Progress(std::string_view what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(double fraction);  // 0..1; at most a few times a second
  // "120 of 1000, 2 min left": of things that take about the same time each.
  void show(std::uint64_t done, std::uint64_t all);

 private:
  bool isTime();
  void write(const std::string& text);
  std::string_view what_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point begin_, next_;
};

}  // namespace merker::app
