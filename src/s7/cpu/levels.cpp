// Priority classes: an OB of a higher class interrupts at an instruction boundary; registers are
// saved and begin at zero (S7-REG-05, -06).
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

constexpr std::size_t kDeepestInterruption = 64;
constexpr std::uint8_t kOnlyErrors = 28;  // class of asynchronous errors in STARTUP (S7-BLK-14)

}  // namespace

std::uint8_t Cpu::priority() const {
  return machine_.levels.empty() ? std::uint8_t{0} : machine_.levels.back().priority;
}

bool Cpu::startLevel(std::uint8_t ob, std::uint8_t priority, const StartInformation& start,
                     bool errorOb) {
  Machine& m = machine_;
  const Code* code = find(m.organizationBlocks, ob);
  if (m.levels.size() >= kDeepestInterruption) {
    stopByFault(Event::StopInterruptStack);
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
  m.registers = {};
  if (!m.enter(code)) return false;
  std::copy(start.begin(), start.end(), m.top->local);
  return true;
}

void Cpu::endLevel() {
  Machine& m = machine_;
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
  if (level.ob == 40) hardwareInterruptEnded(level.start);
  if (level.ob == 1 && mode_ == Mode::Run) endCycle();
}

// The waiting request of the highest class, the oldest among equals, if it is higher than what
// runs.
void Cpu::startWaiting() {
  auto& waiting = interrupts_.waiting;
  if (waiting.empty()) return;
  const bool delayed = std::any_of(machine_.levels.begin(), machine_.levels.end(),
                                   [](const Level& level) { return level.delayed > 0; });
  if (delayed) return;  // SFC 41
  const auto highest =
      std::max_element(waiting.begin(), waiting.end(),
                       [](const Request& a, const Request& b) { return a.priority < b.priority; });
  if (highest->priority <= priority()) return;
  if (mode_ == Mode::Startup && highest->priority < kOnlyErrors) return;  // S7-STATE-11
  const Request request = *highest;
  waiting.erase(highest);
  if (!hasOb(request.ob)) return obMissing(request.start);  // deleted while it waited
  startLevel(request.ob, request.priority, request.start, false);
}

}  // namespace merker::cpu
