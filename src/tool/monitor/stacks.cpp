#include "monitor/stacks.h"

#include "monitor/station_target.h"

namespace merker::monitor {
namespace {

// Which frame is the topmost of each level, outermost level first.
std::vector<std::size_t> topFrames(const cpu::Machine& m) {
  std::vector<std::size_t> tops;
  std::size_t at = 0;  // frame 0 is the empty one below all blocks
  for (const cpu::Level& level : m.levels) tops.push_back(at += level.frames);
  return tops;
}

// After a fault the instruction that failed, otherwise the next one.
std::uint32_t offsetOf(const cpu::Cpu& cpu, const cpu::Frame& frame) {
  const cpu::Machine& m = cpu.machine();
  const bool top = &frame == m.top;
  return top && cpu.mode() == cpu::Mode::Stop ? m.position : cpu.offset(frame);
}

BlockStackEntry entry(const cpu::Cpu& cpu, const block::Program& program, std::size_t index) {
  const cpu::Machine& m = cpu.machine();
  const cpu::Frame& frame = m.frames[index];
  BlockStackEntry result;
  result.place = sourcePlace(program, frame.code->source->id, offsetOf(cpu, frame));
  result.organizationBlock = frame.first;
  const OpenBlocks open = openBlocks(m, index);
  result.db = open.db.number;
  result.di = open.di.number;
  return result;
}

InterruptStackEntry interrupt(const cpu::Cpu& cpu, const block::Program& program, std::size_t index,
                              std::size_t frame) {
  const cpu::Machine& m = cpu.machine();
  const cpu::Level& level = m.levels[index];
  const bool top = index + 1 == m.levels.size();
  InterruptStackEntry result;
  result.ob = level.ob;
  result.priority = level.priority;
  result.errorOb = level.errorOb;
  if (m.frames[frame].code != nullptr)
    result.place =
        sourcePlace(program, m.frames[frame].code->source->id, offsetOf(cpu, m.frames[frame]));
  result.registers =
      toRegisters(top ? m.registers : m.levels[index + 1].interrupted, m.fourAccumulators);
  const std::size_t bracketEnd = top ? m.brackets.size() : m.levels[index + 1].bracketBase;
  const std::size_t mcrEnd = top ? m.mcrStack.size() : m.levels[index + 1].mcrBase;
  for (std::size_t i = level.bracketBase; i < bracketEnd; ++i)
    result.brackets.push_back({m.brackets[i].rlo, m.brackets[i].orBit});
  for (std::size_t i = level.mcrBase; i < mcrEnd; ++i) result.mcr.push_back(m.mcrStack[i] != 0);
  return result;
}

}  // namespace

// What the block above gives back at its end, or what an interrupt has saved, or the present ones.
OpenBlocks openBlocks(const cpu::Machine& m, std::size_t frame) {
  const auto of = [](const cpu::Registers& r) { return OpenBlocks{r.db, r.di, r.ar2}; };
  const std::vector<std::size_t> tops = topFrames(m);
  for (std::size_t level = 0; level + 1 < tops.size(); ++level)
    if (tops[level] == frame) return of(m.levels[level + 1].interrupted);
  if (frame + 1 >= m.frames.size()) return of(m.registers);
  const cpu::Frame& above = m.frames[frame + 1];
  return {above.db, above.di, above.ar2};
}

Stacks stacks(const cpu::Cpu& cpu, const block::Program& program) {
  Stacks result;
  const cpu::Machine& m = cpu.machine();
  if (cpu.mode() != cpu::Mode::Stop && cpu.mode() != cpu::Mode::Halt) return result;
  for (std::size_t i = m.frames.size(); i-- > 1;) {
    result.blocks.push_back(entry(cpu, program, i));
    const cpu::Frame& frame = m.frames[i];
    result.locals.push_back(
        {frame.code->source->id, {frame.local, frame.local + frame.localLength}});
  }
  const std::vector<std::size_t> tops = topFrames(m);
  for (std::size_t i = m.levels.size(); i-- > 0;)
    result.interrupts.push_back(interrupt(cpu, program, i, tops[i]));
  return result;
}

}  // namespace merker::monitor
