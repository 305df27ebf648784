#include "cpu/machine.h"

#include <algorithm>

#include "cpu/cpu.h"
#include "cpu/event.h"

namespace merker::cpu {

Machine::Machine(const CpuModel& cpuModel)
    : fourAccumulators(cpuModel.accumulators == 4),
      areas(cpuModel),
      timers(cpuModel.timers),
      counters(cpuModel.counters),
      loadedTimers(cpuModel.timers),
      model(&cpuModel) {
  image = areas.image.data();
  frames.reserve(64);
  frames.emplace_back();
  top = &frames.back();
  brackets.reserve(64);
  mcrStack.reserve(64);
}

void Machine::updateCallLimit() {
  callLimit = nullptr;
  if (levels.empty() || levels.back().errorOb) return;
  const std::size_t below = frames.size() - levels.back().frames;
  callLimit = frames.data() + std::min(below + model->nesting, frames.capacity() - 1);
}

bool Machine::enter(const Code* code) {
  Level& level = levels.back();
  const std::uint32_t limit = level.errorOb ? model->errorNesting : model->nesting;
  if (level.frames > limit) {  // S7-CPU-26; the OB itself does not count
    cpu->stopByFault(Event::StopBlockNesting);
    return false;
  }
  const std::uint32_t begin = level.frames == 0 ? level.localBase : top->localEnd;
  const std::uint32_t end = begin + code->localBytes;
  if (end > model->localBytes) {  // S7-CPU-25
    cpu->stopByFault(Event::StopLocalData);
    return false;
  }
  frames.push_back({.code = code,
                    .first = level.frames == 0,
                    .local = localStacks[level.localStack].data() + begin,
                    .localLength = end - begin,
                    .localEnd = end,
                    .db = registers.db,
                    .di = registers.di,
                    .ar2 = registers.ar2,
                    .mcrActive = mcrActive,
                    .mcrDepth = static_cast<std::uint16_t>(mcrStack.size()),
                    .bracketDepth = static_cast<std::uint16_t>(brackets.size())});
  top = &frames.back();
  ++level.frames;
  updateCallLimit();
  mcrActive = mcrOff = false;  // a called block begins without MCR
  return true;
}

void Machine::leave() {
  registers.db = top->db;
  registers.di = top->di;
  registers.ar2 = top->ar2;
  mcrActive = top->mcrActive;
  mcrStack.resize(top->mcrDepth);
  brackets.resize(top->bracketDepth);
  updateMcr();
  frames.pop_back();
  top = &frames.back();
  --levels.back().frames;
}

const Frame* Machine::caller() const { return top->first || frames.size() < 2 ? nullptr : top - 1; }

void Machine::reopenBlocks() {
  const auto reopen = [this](OpenBlock& open) { open = dataBlocks.open(open.number); };
  const auto both = [&](Registers& r) { reopen(r.db), reopen(r.di); };
  both(registers);
  for (Level& level : levels) both(level.interrupted);
  for (Frame& frame : frames) reopen(frame.db), reopen(frame.di);
}

}  // namespace merker::cpu
