#include "softplc/quiet_cycles.h"

#include <algorithm>
#include <cstring>

namespace merker::sinumerik {
namespace {

void append(std::vector<std::uint8_t>& to, const void* data, std::size_t bytes) {
  const auto* const from = static_cast<const std::uint8_t*>(data);
  to.insert(to.end(), from, from + bytes);
}

template <typename Cells>
void append(std::vector<std::uint8_t>& to, const Cells& cells) {
  append(to, cells.data(), cells.size() * sizeof(cells[0]));
}

// The parts of memory, one behind the other, with the names of their operands.
template <typename Visit>
void eachPart(const Machine& m, Visit visit) {
  visit("E", m.inputs);
  visit("A", m.outputs);
  visit("M", m.flags);
  visit("T", m.timers);
  visit("Z", m.counters);
  visit("PE", m.periphery.inputs);
  visit("PA", m.periphery.outputs);
  visit("modules", m.periphery.inputPresent);
  visit("modules", m.periphery.outputPresent);
  visit("program", m.blocks.program());
  visit("DB", m.blocks.data());
}

// The data block whose words these are.
Difference dataWord(const BlockMemory& blocks, std::uint32_t word) {
  const std::span<const Entry> list = blocks.list(mc5::BlockType::Db);
  for (std::size_t number = 0; number < list.size(); ++number) {
    const Entry& block = list[number];
    if (block.present && word >= block.start && word - block.start < block.length)
      return {"DB", static_cast<std::uint16_t>(number),
              static_cast<std::uint16_t>(word - block.start)};
  }
  return {"data"};
}

Difference place(const Machine& m, std::size_t byte) {
  std::optional<Difference> found;
  eachPart(m, [&](std::string_view area, const auto& cells) {
    const std::size_t bytes = cells.size() * sizeof(cells[0]), number = byte / sizeof(cells[0]);
    if (!found && byte < bytes)
      found = area == "DB" ? dataWord(m.blocks, static_cast<std::uint32_t>(number))
                           : Difference{area, static_cast<std::uint16_t>(number)};
    byte -= found ? 0 : bytes;
  });
  return found.value_or(Difference{"program"});
}

}  // namespace

// True if memory is as it was at the checkpoint before.
bool QuietCycles::remember(const Machine& m) {
  next_.clear();
  eachPart(m, [&](std::string_view, const auto& cells) { append(next_, cells); });
  const std::uint64_t version = m.blocks.version();
  append(next_, &version, sizeof version);
  if (next_ == memory_) return true;
  const auto at = std::ranges::mismatch(next_, memory_).in1 - next_.begin();
  found_ = place(m, static_cast<std::size_t>(at));
  memory_.swap(next_);
  return false;
}

// Each cycle once, however often it is asked for.
void QuietCycles::count(std::uint64_t cycle, NotQuiet why) {
  if (cycle == counted_) return;
  counted_ = cycle;
  ++counts_[static_cast<std::size_t>(why)];
}

bool QuietCycles::wants(std::uint64_t number, std::uint64_t cycle) {
  if ((known_ && at_.number == number) || patience_.wants()) return true;
  forget();
  leftOut_ = true;
  count(cycle, NotQuiet::LeftOut);
  return false;
}

NotQuiet QuietCycles::whyFirst() {
  const bool left = leftOut_, starts = at_.number - at_.cycle != starts_;
  leftOut_ = false;
  starts_ = at_.number - at_.cycle;
  return left ? NotQuiet::LeftOut : starts ? NotQuiet::Start : NotQuiet::Outside;
}

bool QuietCycles::fail(NotQuiet why) {
  count(at_.cycle, why);
  patience_.failed(next_.size());
  return false;
}

void QuietCycles::refuse(std::uint64_t cycle, NotQuiet why) {
  forget();
  at_.cycle = cycle;
  fail(why);
}

bool QuietCycles::prove(const Machine& m, const Checkpoint& now, Duration raster) {
  const bool same = remember(m);
  const Checkpoint before = at_;
  const bool follows = known_ && now.number == before.number + 1;
  known_ = true;
  at_ = now;
  if (!follows) return count(at_.cycle, whyFirst()), false;
  if (now.levels != before.levels + 1 || now.alarms != before.alarms) return fail(NotQuiet::Level);
  if (now.macros != before.macros) return fail(NotQuiet::Macro);
  if (!same) where_ = found_;
  if (!same) return fail(NotQuiet::Memory);
  if (before.nextEvent <= now.clock || now.nextEvent <= now.clock + raster)
    return fail(NotQuiet::Event);
  if (now.clock - before.clock != raster || now.relative != before.relative ||
      now.relative.requested)
    return fail(NotQuiet::Duration);
  count(at_.cycle, NotQuiet::Proof);
  patience_.found();
  length_ = raster;
  perCycle_ = now.instructions - before.instructions;
  return true;
}

std::uint64_t QuietCycles::judge(const Machine& m, const Checkpoint& now, Duration raster,
                                 Instant limit) {
  // Asked again at the same checkpoint: whoever kept a reference to memory may have written.
  const bool again = known_ && at_.number == now.number;
  proven_ = again ? remember(m) && proven_ : prove(m, now, raster);
  if (!proven_) return 0;
  const Instant last = std::min(limit, at_.nextEvent - Duration{1});
  return last <= at_.clock ? 0 : static_cast<std::uint64_t>((last - at_.clock).ns / length_.ns);
}

void QuietCycles::passed(std::uint64_t cycles) {
  passed_ += cycles;
  at_.clock = at_.clock + length_ * static_cast<std::int64_t>(cycles);
  at_.number += cycles;
  at_.cycle += cycles;
  at_.instructions += perCycle_ * cycles;
  at_.levels += cycles;
}

}  // namespace merker::sinumerik
