// Synchronous errors, faults that end in STOP, entries of the diagnostic buffer (S7-ERR-02 … -04,
// S7-DIAG-01 … -03).
#include <algorithm>

#include "base/bytes.h"
#include "cpu/cpu.h"

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

Place Cpu::here() const {
  if (machine_.levels.empty() || machine_.top->code == nullptr) return {};
  return {.known = true, .block = machine_.top->code->source->id, .offset = machine_.position};
}

DateAndTime Cpu::dateAndTime() const { return toDateAndTime(clock_.milliseconds(machine_.clock)); }

DiagnosticEvent Cpu::makeEvent(std::uint16_t event, std::string text, Place place) const {
  DiagnosticEvent result{.event = event,
                         .time = machine_.clock,
                         .text = std::move(text),
                         .place = place,
                         .stamp = dateAndTime()};
  const DiagnosticInformation info = informationOf(place);
  result.info[0] = priority();
  result.info[1] = machine_.levels.empty() ? std::uint8_t{0} : machine_.levels.back().ob;
  std::copy(info.begin(), info.end(), result.info.begin() + 2);
  return result;
}

void Cpu::report(std::uint16_t event, std::string text, Place place) {
  diagnostics_.add(makeEvent(event, std::move(text), place));
}

void Cpu::note(std::uint16_t event, std::string text, const DiagnosticInformation& info) {
  DiagnosticEvent entry = makeEvent(event, std::move(text), {});
  std::copy(info.begin(), info.end(), entry.info.begin() + 2);
  diagnostics_.add(std::move(entry));
}

// An entry that says what the OB's start information says.
void Cpu::report(const StartInformation& start, std::string text) {
  DiagnosticEvent entry = makeEvent(loadWord(start.data()), std::move(text), here());
  std::copy_n(start.begin() + 2, entry.info.size(), entry.info.begin());
  diagnostics_.add(std::move(entry));
}

void Cpu::report(Event event) {
  report(static_cast<std::uint16_t>(event), std::string(text(event)));
}

AfterError Cpu::synchronousError(const SyncError& error) {
  Machine& m = machine_;
  if (masked(m.levels.back().masks, error)) return AfterError::GoOn;
  const std::string kind = error.peripheral() ? "" : "programming error: ";
  const StartInformation start =
      errorInformation(error, priority(), m.top->code->source->id, m.position, dateAndTime());
  report(start, kind + describe(error));
  faults_.program = true;
  const std::uint8_t ob = error.peripheral() ? 122 : 121;
  if (!hasOb(ob)) {
    stopByFault(error.peripheral() ? Event::StopAccessError : Event::StopProgrammingError,
                describe(error));
    return AfterError::Stopped;
  }
  if (nestedErrors(m.levels) >= kNestedErrors) {
    stopByFault(Event::StopErrorNesting, describe(error));
    return AfterError::Stopped;
  }
  return startLevel(ob, priority(), start, true) ? AfterError::ErrorOb : AfterError::Stopped;
}

void Cpu::stopByFault(Event why, std::string detail) {
  std::string reason(text(why));
  if (!detail.empty()) reason += ": " + detail;
  goToStop(why, std::move(reason), here(), true);
}

}  // namespace merker::cpu
