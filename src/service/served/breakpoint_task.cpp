#include "served/breakpoint_task.h"

#include <algorithm>

#include "base/bytes.h"
#include "served/block_task.h"
#include "served/test_stacks.h"

namespace merker::served {

BreakpointTask::BreakpointTask(std::shared_ptr<s7comm::Outlet> client, s7comm::TestJob job,
                               monitor::Monitor& monitor)
    : TestTask(std::move(client), std::move(job)), monitor_(monitor) {
  constexpr std::uint16_t kWhenEnabled = 1;
  const s7comm::BlockWatch& watch = TestTask::job().block;
  place_ = monitor::sourcePlace(*monitor.program().find(watchedBlock(watch)), watch.begin);
  number_ = monitor.debugger().setBreakpoint(place_).number;
  enable(TestTask::job().how != kWhenEnabled);
}

void BreakpointTask::enable(bool on) {
  TestTask::enable(on);
  monitor_.debugger().enableBreakpoint(number_, on);
}

void BreakpointTask::end(monitor::Monitor& monitor) {
  monitor.debugger().giveUpStep();
  monitor.debugger().removeBreakpoint(number_);
}

// Behind a single step, which may end anywhere, each job tells; else the one whose place it is.
bool BreakpointTask::standsHere(const monitor::Monitor& monitor) const {
  const auto position = monitor.debugger().position();
  if (monitor.plc().mode() != controller::Mode::Halt || !position) return false;
  const auto is = [&](const monitor::SourcePlace& place) {
    return place.block == position->block && place.offset == position->offset;
  };
  return is(place_) ||
         std::ranges::none_of(monitor.debugger().breakpoints(), is, &monitor::Breakpoint::place);
}

bool BreakpointTask::run(monitor::Monitor& monitor) {
  const bool here = enabled() && standsHere(monitor);
  if (here && !std::exchange(told_, true)) tell(data(monitor));
  if (!here) told_ = false;
  return true;
}

// Where the program stands, where the breakpoint is, 0, STW, both accumulators, both address
// registers, the open data blocks: as Wireshark's dissector has it.
s7comm::Bytes BreakpointTask::data(const monitor::Monitor& monitor) const {
  s7comm::Bytes data;
  appendPlace(data, monitor.debugger().position().value_or(place_));
  appendPlace(data, place_);
  appendWord(data, 0);
  constexpr std::uint8_t kAll = s7comm::kStatusWord | s7comm::kAccu1 | s7comm::kAccu2 |
                                s7comm::kAr1 | s7comm::kAr2 | s7comm::kDb;
  s7comm::appendRegisters(data, testRegisters(monitor.registers()), kAll);
  return data;
}

}  // namespace merker::served
