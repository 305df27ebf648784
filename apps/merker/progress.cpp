#include "progress.h"

#include <unistd.h>

#include <iostream>

namespace merker::app {

using Clock = std::chrono::steady_clock;
constexpr auto kPause = std::chrono::milliseconds(300);

Progress::Progress(std::string_view what)
    : what_(what), terminal_(isatty(STDERR_FILENO) == 1), next_(Clock::now() + kPause) {}

Progress::~Progress() {
  if (shown_) std::cerr << "\r\033[K" << std::flush;
}

void Progress::show(double fraction) {
  if (!terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + kPause;
  shown_ = true;
  std::cerr << '\r' << what_ << ' ' << static_cast<int>(fraction * 100) << " %\033[K" << std::flush;
}

}  // namespace merker::app
