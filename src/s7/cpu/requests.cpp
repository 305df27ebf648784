// Requests of OBs: which events wait, which are lost, and what an OB that is not loaded means
// (S7-ERR-01, -05; S7-OBI-07, -10).
#include <algorithm>

#include "base/bytes.h"
#include "cpu/asynchronous_errors.h"
#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

// Requests that wait in one priority class: docs/compatibility.md, "requests of OBs".
constexpr std::ptrdiff_t kRequestsPerClass = 32;
constexpr std::uint8_t kErrorInStartup = 28;  // S7-BLK-14

}  // namespace

bool Cpu::runsOrWaits(std::uint8_t ob) const {
  const auto& waiting = interrupts_.waiting;
  const auto& levels = machine_.levels;
  return std::any_of(waiting.begin(), waiting.end(),
                     [&](const Request& r) { return r.ob == ob; }) ||
         std::any_of(levels.begin(), levels.end(),
                     [&](const Level& level) { return level.ob == ob; });
}

// Interrupts of time: one at a time.
void Cpu::request(const StartInformation& start) {
  const std::uint8_t ob = start[3];
  if (interrupts_.isLocked(ob) || mode_ == Mode::Stop) return;
  if (!hasOb(ob)) return obMissing(start);
  if (!runsOrWaits(ob)) return queue(start);
  constexpr std::uint8_t kStillRunning = 0x02;
  timeError(kStillRunning, loadWord(&start[6]), start);
}

void Cpu::queue(StartInformation start) {
  const std::uint8_t ob = start[3];
  if (mode_ == Mode::Startup && ob >= 80) start[2] = kErrorInStartup;
  const std::uint8_t priority = start[2];
  auto& waiting = interrupts_.waiting;
  const auto same = std::count_if(waiting.begin(), waiting.end(),
                                  [&](const Request& r) { return r.priority == priority; });
  constexpr std::uint8_t kOverflow = 0x07;
  if (same >= kRequestsPerClass && ob != 80)
    return timeError(kOverflow, loadWord(&start[6]), start);
  waiting.push_back({.ob = ob, .priority = priority, .start = start});
  machine_.interrupt();
}

// `cause` is the start information of the OB that could not begin, or of the one that took too
// long.
void Cpu::timeError(std::uint8_t faultId, std::uint32_t info, const StartInformation& cause) {
  StartInformation start = startInformation(0x35, faultId, priorityOf(80), 80, dateAndTime());
  setWord(start, 6, info);
  std::copy_n(cause.begin(), 4, start.begin() + 8);  // class, number, priority, OB
  asynchronousError(start);
}

// S7-OBI-10: bytes 8 and 9 the event, 10 and 11 who was running.
void Cpu::obMissing(const StartInformation& wanted) {
  StartInformation start = startInformation(0x35, 0xA1, priorityOf(85), 85, dateAndTime());
  std::copy_n(wanted.begin() + 6, 2, start.begin() + 6);
  std::copy_n(wanted.begin(), 2, start.begin() + 8);
  setByte(start, 10, priority());
  setByte(start, 11, machine_.levels.empty() ? 0u : machine_.levels.back().ob);
  asynchronousError(start, "OB " + std::to_string(wanted[3]));
}

void Cpu::asynchronousError(const StartInformation& start, std::string_view detail) {
  const std::uint8_t ob = start[3];
  std::string words = describe(start);
  if (!detail.empty()) words.append(": ").append(detail);
  report(start, words);
  if (!comesFromModule(ob)) faults_.program = true;
  if (mode_ == Mode::Stop || interrupts_.isLocked(ob)) return;  // SFC 39: entered only
  if (hasOb(ob)) {
    if (ob != 80 || !runsOrWaits(ob))
      queue(start);  // one OB 80 at a time; the entry tells the rest
  } else if (const auto why = stopWithout(ob)) {
    stopByFault(*why, words);
  }
}

}  // namespace merker::cpu
