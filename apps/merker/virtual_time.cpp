#include "virtual_time.h"

#include <algorithm>

#include "progress.h"
#include "serial_link.h"

namespace merker::app {

void moveTo(controller::Controller& plc, SerialLink* link, Instant end) {
  for (; link != nullptr && link->next() < end; link->exchange())
    plc.advanceTo(std::max(plc.now(), link->next()));
  plc.advanceTo(end);
}

void runFor(controller::Controller& plc, Duration time, SerialLink* link) {
  Progress progress("running");
  const Instant start = plc.now(), end = start + time;
  while (plc.now() < end) {
    moveTo(plc, link, std::min(end, plc.now() + Duration::milliseconds(100)));
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
