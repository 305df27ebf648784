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

}  // namespace

// True if memory is as it was at the checkpoint before.
bool QuietCycles::remember(const Machine& m) {
  next_.clear();
  append(next_, m.inputs);
  append(next_, m.outputs);
  append(next_, m.flags);
  append(next_, m.timers);
  append(next_, m.counters);
  append(next_, m.periphery.inputs);
  append(next_, m.periphery.outputs);
  append(next_, m.periphery.inputPresent);
  append(next_, m.periphery.outputPresent);
  append(next_, m.blocks.program());
  append(next_, m.blocks.data());
  const std::uint64_t version = m.blocks.version();
  append(next_, &version, sizeof version);
  const bool same = next_ == memory_;
  if (!same) memory_.swap(next_);
  return same;
}

bool QuietCycles::fail(NotQuiet why) {
  ++counts_[static_cast<std::size_t>(why)];
  return false;
}

void QuietCycles::refuse(NotQuiet why) {
  forget();
  fail(why);
}

bool QuietCycles::prove(const Machine& m, const Checkpoint& now, Duration raster) {
  const bool same = remember(m);
  const Checkpoint before = at_;
  const bool follows = known_ && now.number == before.number + 1;
  known_ = true;
  at_ = now;
  if (!follows) return fail(NotQuiet::Outside);
  if (now.levels != before.levels + 1 || now.alarms != before.alarms) return fail(NotQuiet::Level);
  if (now.macros != before.macros) return fail(NotQuiet::Macro);
  if (!same) return fail(NotQuiet::Memory);
  if (before.nextEvent <= now.clock || now.nextEvent <= now.clock + raster)
    return fail(NotQuiet::Event);
  if (now.clock - before.clock != raster || now.relative != before.relative ||
      now.relative.requested)
    return fail(NotQuiet::Duration);
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
  at_.instructions += perCycle_ * cycles;
  at_.levels += cycles;
}

}  // namespace merker::sinumerik
