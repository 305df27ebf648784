// Synchronous errors (S7-ERR-02 … -04).
#include "cpu/cpu.h"
#include "cpu/levels.h"

namespace merker::cpu {
namespace {

constexpr unsigned kNestedErrors = 4;  // S7-ERR-04

unsigned nestedErrors(const std::vector<Level>& levels) {
  unsigned count = 0;
  for (auto level = levels.rbegin(); level != levels.rend() && level->errorOb; ++level) ++count;
  return count;
}

// SFC 36: bit 1 stands for 16#21 … bit 31 for 16#3F; access errors: bit 2 reading, bit 3 writing.
bool masked(ErrorMasks& masks, const SyncError& error) {
  const auto code = static_cast<unsigned>(error.code);
  const std::uint32_t bit = error.peripheral() ? 1u << (code - 0x40) : 1u << (code - 0x20);
  std::uint32_t& seen = error.peripheral() ? masks.accessSeen : masks.programSeen;
  if (((error.peripheral() ? masks.accessMask : masks.programMask) & bit) == 0) return false;
  seen |= bit;
  return true;
}

}  // namespace

AfterError Cpu::synchronousError(const SyncError& error) {
  Machine& m = machine_;
  m.outlook.until(m.clock,
                  {.at = Look::At::Error, .block = m.top->code->source->id, .offset = m.position});
  if (masked(m.levels.back().masks, error)) return AfterError::GoOn;
  const std::string kind = error.peripheral() ? "" : "programming error: ";
  const StartInformation start = errorInformation(
      error, runningPriority(m), m.top->code->source->id, m.position, log_.dateAndTime());
  log_.report(start, kind + describe(error));
  faults_.program = true;
  const std::uint8_t ob = error.peripheral() ? 122 : 121;
  if (!hasOb(m, ob)) {
    stopByFault(error.peripheral() ? Event::StopAccessError : Event::StopProgrammingError,
                describe(error));
    return AfterError::Stopped;
  }
  if (nestedErrors(m.levels) >= kNestedErrors) {
    stopByFault(Event::StopErrorNesting, describe(error));
    return AfterError::Stopped;
  }
  return startLevel(m, ob, runningPriority(m), start, true) ? AfterError::ErrorOb
                                                            : AfterError::Stopped;
}

}  // namespace merker::cpu
