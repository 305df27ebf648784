#include "cpu/levels.h"

#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

constexpr std::size_t kDeepestInterruption = 64;

}  // namespace

bool startLevel(Machine& m, std::uint8_t ob, std::uint8_t priority, const StartInformation& start,
                bool errorOb) {
  const Code* code = find(m.organizationBlocks, ob);
  if (m.levels.size() >= kDeepestInterruption) {
    m.cpu->stopByFault(Event::StopInterruptStack);
    return false;
  }
  Level level{.ob = ob, .priority = priority, .errorOb = errorOb};
  if (errorOb) {  // same class: goes on in its local data
    level.localStack = m.levels.back().localStack;
    level.localBase = m.top->localEnd;
    level.masks = m.levels.back().masks;
  } else if (!m.levels.empty()) {
    level.localStack = m.levels.back().localStack + 1;
  }
  level.bracketBase = static_cast<std::uint16_t>(m.brackets.size());
  level.mcrBase = static_cast<std::uint16_t>(m.mcrStack.size());
  level.mcrActive = m.mcrActive;
  level.interrupted = m.registers;
  level.start = start;
  if (m.localStacks.size() <= level.localStack) m.localStacks.resize(level.localStack + 1);
  auto& stack = m.localStacks[level.localStack];
  if (stack.empty()) stack.resize(m.model->localBytes);

  m.levels.push_back(level);
  ++m.levelsStarted;
  m.registers = {};
  if (!m.enter(code)) return false;
  std::copy(start.begin(), start.end(), m.top->local);
  return true;
}

Level endLevel(Machine& m) {
  const Level level = m.levels.back();
  m.frames.resize(m.frames.size() - level.frames);
  m.top = &m.frames.back();
  m.levels.pop_back();
  if (level.errorOb) m.levels.back().masks = level.masks;  // of one class (S7-SFC-14)
  m.updateCallLimit();
  m.registers = level.interrupted;
  m.mcrActive = level.mcrActive;
  m.mcrStack.resize(level.mcrBase);
  m.brackets.resize(level.bracketBase);
  m.updateMcr();
  m.levelEnded = false;
  return level;
}

void clearStacks(Machine& m) {
  m.levels.clear();
  m.frames.resize(1);
  m.top = &m.frames.back();
  m.updateCallLimit();
  m.brackets.clear();
  m.mcrStack.clear();
  m.mcrActive = m.mcrOff = m.levelEnded = false;
  m.registers = {};
}

}  // namespace merker::cpu
