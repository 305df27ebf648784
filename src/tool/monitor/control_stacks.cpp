#include "monitor/control_stacks.h"

#include <algorithm>
#include <span>

#include "mc5/block_id.h"
#include "monitor/control_target.h"

namespace merker::monitor {
namespace {

using sinumerik::Level;

// Where a block goes on: behind the parameters of its call, not in front of the jump over them.
SourcePlace returnPlace(const ProgramCode& program, mc5::BlockId block, std::uint32_t word) {
  const BlockId id = mc5::neutralId(block);
  const auto code = program.find(id);
  while (code && word < code->length() && code->instructionAt(word) != word) ++word;
  return sourcePlace(program, id, word);
}

SourcePlace placeOf(const sinumerik::Frame& frame, const ProgramCode& program) {
  return returnPlace(program, frame.block, frame.next - frame.start);
}

// The alarm level (OB 2) interrupts; nothing of STEP 5 has a priority number of its own.
InterruptStackEntry levelOf(const Level& level, std::size_t index, const ProgramCode& program) {
  InterruptStackEntry entry;
  entry.ob = level.ob;
  entry.priority = static_cast<std::uint8_t>(index + 1);
  if (!level.frames.empty()) {
    entry.place = placeOf(level.frames.back(), program);
    entry.registers = toRegisters(level.registers, openBlock(level.frames.back()));
  }
  for (const sinumerik::Bracket& bracket : level.registers.brackets)
    entry.brackets.push_back({bracket.vke, bracket.orBit});
  return entry;
}

Stacks inHalt(const sinumerik::Machine& m, const ProgramCode& program) {
  Stacks result;
  for (std::size_t i = m.levels.size(); i-- > 0;) {
    const Level& level = m.levels[i];
    for (std::size_t frame = level.frames.size(); frame-- > 0;)
      result.blocks.push_back({.place = placeOf(level.frames[frame], program),
                               .db = openBlock(level.frames[frame]),
                               .di = 0,
                               .organizationBlock = frame == 0});
    result.interrupts.push_back(levelOf(level, i, program));
  }
  return result;
}

// The screens USTACK and BSTACK (S5-ERR-08, -10).
Stacks afterStop(const sinumerik::StopPicture& picture, const ControlTarget& target) {
  const sinumerik::InterruptStack& top = picture.interrupt;
  const auto place = target.position();
  Stacks result;
  if (!place) return result;
  result.blocks.push_back({.place = *place, .db = top.dataBlock.value_or(0), .di = 0});
  // A block stack that overflows has the block that found no room as its first entry, too.
  const std::size_t twice = top.causes.test(sinumerik::Cause::STUEB) ? 1 : 0;
  const std::span blocks(picture.blocks);
  for (const sinumerik::BlockStackEntry& entry : blocks.subspan(std::min(twice, blocks.size())))
    result.blocks.push_back({.place = returnPlace(target.program(), entry.block, entry.relative),
                             .db = entry.dataBlock.value_or(0),
                             .di = 0});
  InterruptStackEntry interrupt;
  for (BlockStackEntry& entry : result.blocks) {
    entry.organizationBlock = entry.place.block.kind == BlockKind::OB;
    if (!entry.organizationBlock) continue;
    if (interrupt.priority++ == 0)
      interrupt.ob = static_cast<std::uint8_t>(entry.place.block.number);
  }
  interrupt.place = *place;
  interrupt.registers = toRegisters(top);
  result.interrupts.push_back(std::move(interrupt));
  return result;
}

}  // namespace

Stacks controlStacks(const sinumerik::Plc& plc, const ControlTarget& target) {
  if (plc.mode() == sinumerik::Mode::Halt) return inHalt(plc.machine(), target.program());
  if (plc.mode() != sinumerik::Mode::Stop) return {};
  return afterStop(plc.operatingSystem().record().picture(), target);
}

}  // namespace merker::monitor
