// SFB 47 COUNT (technology manual 5.5.5, 5.10.5; CNT-IF47).
#include "system/technology_block.h"
#include "technology/counter.h"

namespace merker::system {
namespace {

void show(Sfb<47>& a, const technology::Counter& counter) {
  showCount(a, counter);
  a.set("STS_LTCH", channelOf(a).level(technology::Channel::LatchInput));
  a.set("LATCHVAL", static_cast<std::uint32_t>(counter.latched()));
  a.set("STS_CMP", counter.comparator().reached());
  a.set("STS_ZP", counter.zero());
  if (a.has("TIMEVAL"))
    a.set("TIMEVAL", counter.period());  // docs/compatibility.md: IDBs of 34 bytes
}

}  // namespace

// Inputs, job, outputs; a reset of the status bits shows in the next call (CNT-JOB-09,
// CNT-IF47-11).
void countBlock(Sfb<47>& a) {
  auto* counter = functionOf<technology::Counter>(a);
  if (counter == nullptr) return;
  act(a);
  counter->control(a.flag("SW_GATE"), a.flag("CTRL_DO"), a.flag("SET_DO"), a.machine().clock);
  runJob(a, [&](std::uint32_t id, std::int32_t value) { return counter->job(id, value); });
  show(a, *counter);
  if (a.flag("RES_STS")) counter->resetStatus();
}

}  // namespace merker::system
