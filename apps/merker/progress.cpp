#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <iostream>

namespace merker::app {

using Clock = std::chrono::steady_clock;
constexpr auto kPause = std::chrono::milliseconds(300);

namespace {

// "40 s", "12 min", "3 h"
std::string roughly(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 1.5 * kMinute) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 1.5 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.0f} h", seconds / kHour);
}

}  // namespace

Progress::Progress(std::string_view what)
    : what_(what),
      terminal_(isatty(STDERR_FILENO) == 1),
      begin_(Clock::now()),
      next_(begin_ + kPause) {}

Progress::~Progress() {
  if (shown_) std::cerr << "\r\033[K" << std::flush;
}

bool Progress::isTime() {
  if (!terminal_ || Clock::now() < next_) return false;
  next_ = Clock::now() + kPause;
  return true;
}

void Progress::write(const std::string& text) {
  shown_ = true;
  std::cerr << '\r' << what_ << ' ' << text << "\033[K" << std::flush;
}

void Progress::show(double fraction) {
  if (isTime()) write(fmt::format("{} %", static_cast<int>(fraction * 100)));
}

void Progress::show(std::uint64_t done, std::uint64_t all) {
  if (!isTime()) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  const std::string left =
      done == 0
          ? std::string()
          : ", " + roughly(seconds * static_cast<double>(all - done) / static_cast<double>(done)) +
                " left";
  write(fmt::format("{} of {}{}", done, all, left));
}

}  // namespace merker::app
