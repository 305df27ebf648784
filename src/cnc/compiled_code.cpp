#include "cnc/compiled_code.h"

#include "cnc/seat.h"

namespace merker::cnc {
namespace {

using sinumerik::Machine;

// More brackets than that are near the limit of the processor.
constexpr std::size_t kOpenBrackets = 32;

}  // namespace

// As the running call sees the block, or as all of them do.
const CompiledCode::Entry& CompiledCode::entryAt(const sinumerik::Frame& frame) const {
  const std::uint32_t number =
      frame.parameters < variantOf_.size() ? variantOf_[frame.parameters] : 0;
  if (number == 0) return entries_[frame.next];
  const Variant& variant = variants_[number - 1];
  const std::uint32_t at = frame.next - variant.start;
  const bool inside = variant.start == frame.start && at < variant.entries.size();
  return inside ? variant.entries[at] : entries_[frame.next];
}

// False: the processor is next. Of code and link the code comes first: it knows whether a condition
// is met.
bool CompiledCode::goOn(Seat& seat, Machine& m) const {
  sinumerik::Frame& frame = m.frame();
  if (frame.next >= entries_.size()) return false;
  const Entry& entry = entryAt(frame);
  const std::uint64_t before = seat.instructions;
  if (entry.code != nullptr) {
    const void* const answer = entry.code->run(&seat, frame.next - entry.start);
    frame.next = entry.start + static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(answer));
    if (seat.instructions != before) return true;
  }
  const std::uint32_t number = entries_[frame.next].link;
  if (number == 0 || seat.clock >= seat.horizon) return false;
  const Link& link = links_[number - 1];
  if (!follow(link, m, seat.displays)) return false;
  seat.clock = seat.clock + link.time;
  ++seat.instructions;
  takeData(seat, m);
  return true;
}

std::uint64_t CompiledCode::run(Machine& m, Instant horizon) {
  sinumerik::Registers& registers = m.registers();
  if (registers.brackets.size() > kOpenBrackets) return 0;
  Seat seat{.clock = m.clock,
            .horizon = horizon,
            .images = &m.inputs,
            .akku1 = registers.akku1,
            .akku2 = registers.akku2,
            .displays = registers.displays,
            .cells = &m.timers};
  takeData(seat, m);
  while (goOn(seat, m)) {
  }
  if (seat.instructions == 0) return 0;
  m.clock = seat.clock;
  registers.akku1 = seat.akku1;
  registers.akku2 = seat.akku2;
  registers.displays = seat.displays;
  instructions_ += seat.instructions;
  return seat.instructions;
}

}  // namespace merker::cnc
