#include "virtual_time.h"

#include <algorithm>
#include <chrono>

#include "progress.h"
#include "serial_link.h"

namespace merker::app {

void moveTo(controller::Controller& plc, SerialLink* link, Instant end) {
  for (; link != nullptr && link->next() < end; link->exchange())
    plc.advanceTo(std::max(plc.now(), link->next()));
  plc.advanceTo(end);
}

namespace {

constexpr Duration kShortest = Duration::milliseconds(100);

// As much virtual time at once as passes between two looks at the progress: where cycles are passed
// over, hours.
Duration nextPortion(Duration portion, std::chrono::nanoseconds taken) {
  using std::chrono::milliseconds;
  constexpr Duration kLongest = Duration::seconds(3600);
  if (taken < milliseconds(5)) return std::min(portion * 2, kLongest);
  return taken > milliseconds(50) ? std::max(Duration{portion.ns / 2}, kShortest) : portion;
}

}  // namespace

void runFor(controller::Controller& plc, Duration time, SerialLink* link) {
  Progress progress("running");
  const Instant start = plc.now(), end = start + time;
  Duration portion = kShortest;
  while (plc.now() < end) {
    const auto begin = std::chrono::steady_clock::now();
    moveTo(plc, link, std::min(end, plc.now() + portion));
    portion = nextPortion(portion, std::chrono::steady_clock::now() - begin);
    progress.show(static_cast<double>((plc.now() - start).ns) / static_cast<double>(time.ns));
  }
}

void runCycles(controller::Controller& plc, std::uint64_t count) {
  Progress progress("running");
  constexpr std::uint64_t kPortion = 1000;
  for (std::uint64_t done = 0; done < count && plc.mode() != controller::Mode::Stop;
       done += kPortion) {
    const std::uint64_t portion = std::min(kPortion, count - done), end = plc.cycles() + portion;
    plc.advanceCycles(portion);
    if (plc.cycles() < end) return;
    progress.show(static_cast<double>(done) / static_cast<double>(count));
  }
}

}  // namespace merker::app
