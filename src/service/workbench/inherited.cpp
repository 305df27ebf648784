#include "workbench/inherited.h"

#include "cpu/cpu.h"
#include "cpu/same_code.h"

namespace merker::workbench {
namespace {

// As after each download: a data block that came anew has the values that it came with.
bool outlives(const block::RetentiveDataBlock& data, const block::Program& before,
              const block::Program& now) {
  const BlockId id{BlockKind::DB, data.number};
  const auto fresh = now.find(id), old = before.find(id);
  if (data.madeByProgram) return fresh == now.end();
  return fresh != now.end() && old != before.end() && cpu::sameData(old->second, fresh->second);
}

// The memory of the one with the addresses and interrupts of the other.
cpu::Snapshot merged(station::BlockCpu& fresh, station::BlockCpu& before) {
  cpu::Snapshot result = before.cpu().snapshot(), own = fresh.cpu().snapshot();
  std::erase_if(result.memory.dataBlocks, [&](const block::RetentiveDataBlock& data) {
    return !outlives(data, before.program(), fresh.program());
  });
  result.images = std::move(own.images);
  result.inputs = std::move(own.inputs);
  result.outputs = std::move(own.outputs);
  result.interrupts = std::move(own.interrupts);
  return result;
}

}  // namespace

// Flags, timers and counters are all there until the next start: a warm restart leaves those that
// the new configuration has retentive. A force whose operand went with a module is gone.
void inherit(Plc& fresh, Plc& before) {
  station::BlockCpu *const here = fresh.blockCpu(), *const old = before.blockCpu();
  if (here == nullptr || old == nullptr || &here->model() != &old->model()) return;
  here->take(merged(*here, *old), here->loaded());
  for (const monitor::Forced& one : before.monitor().forces())
    fresh.monitor().force(std::vector{monitor::Change{one.operand, {one.value, {}}}});
}

}  // namespace merker::workbench
