#include "real_time.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>

#include "serial_link.h"
#include "watchdog.h"

namespace merker::app {
namespace {

using Clock = std::chrono::steady_clock;

using std::chrono::nanoseconds;

// How late inputs and outputs may be; short enough that nobody sees it. And while somebody waits
// for the end of a cycle.
constexpr std::chrono::milliseconds kSlice(5);
constexpr std::chrono::microseconds kShortSlice(250);

sigset_t endSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

// Between two slices. True: somebody wants an end. Waiting for the signal is the pause as well.
bool pause(const Guests& guests) {
  const nanoseconds longest = guests.waiting() ? nanoseconds(kShortSlice) : nanoseconds(kSlice);
  if (guests.bell != nullptr) return guests.bell->wait(longest), endAsked();
  const timespec time{0, longest.count()};
  const sigset_t signals = endSignals();
  return sigtimedwait(&signals, nullptr, &time) >= 0;
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

bool endWaits() {
  sigset_t waiting;
  sigemptyset(&waiting);
  sigpending(&waiting);
  return sigismember(&waiting, SIGINT) == 1 || sigismember(&waiting, SIGTERM) == 1;
}

void releaseSignals() {
  const sigset_t signals = endSignals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void endAtOnce() {
  releaseSignals();  // one that waits ends the process here
  std::raise(SIGTERM);
  std::_Exit(1);
}

void runRealTime(controller::Controller& station, SerialLink* link, const Guests& guests,
                 Instant end) {
  Watchdog watchdog("merker run");
  const auto start = Clock::now();
  const Instant origin = station.now();
  const auto elapsed = [&] {
    return Duration{
        std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count()};
  };
  while (watchdog.leave(), !pause(guests)) {
    watchdog.enter("the PLC");
    // A program that costs more than real time falls behind; it must still be able to end.
    const Instant target =
        std::min({origin + elapsed(), station.now() + Duration::milliseconds(100), end});
    if (link != nullptr) link->exchange();
    if (guests.slice) guests.slice();
    while (station.now() < target) {
      station.advanceTo(link == nullptr ? target : std::min(target, link->next()));
      if (link != nullptr && link->next() <= station.now()) link->exchange();
    }
    if (station.now() >= end) return;
    if (!guests.slice && station.mode() == controller::Mode::Stop) return;
  }
}

}  // namespace merker::app
