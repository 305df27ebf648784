#include "real_time.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>

namespace merker::app {
namespace {

using Clock = std::chrono::steady_clock;

// How late inputs and outputs may be; short enough that nobody sees it.
constexpr timespec kSlice = {0, 5'000'000};

sigset_t endSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

void holdSignals() {
  const sigset_t signals = endSignals();
  sigprocmask(SIG_BLOCK, &signals, nullptr);
}

bool endAsked() {
  const sigset_t signals = endSignals();
  constexpr timespec kNow = {0, 0};
  return sigtimedwait(&signals, nullptr, &kNow) >= 0;
}

void runRealTime(controller::Controller& station) {
  const sigset_t signals = endSignals();
  const auto start = Clock::now();
  const Instant origin = station.now();
  const auto elapsed = [&] {
    return Duration{
        std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count()};
  };
  // Waiting for a signal is the pause as well.
  while (sigtimedwait(&signals, nullptr, &kSlice) < 0) {
    // A program that costs more than real time falls behind; it must still be able to end.
    const Instant target =
        std::min(origin + elapsed(), station.now() + Duration::milliseconds(100));
    if (target > station.now()) station.advanceTo(target);
    if (station.mode() == controller::Mode::Stop) return;
  }
}

}  // namespace merker::app
