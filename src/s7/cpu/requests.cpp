#include "cpu/requests.h"

#include <algorithm>

#include "base/bytes.h"
#include "cpu/asynchronous_errors.h"
#include "cpu/levels.h"

namespace merker::cpu {
namespace {

// Requests that wait in one priority class: docs/compatibility.md, "requests of OBs".
constexpr std::ptrdiff_t kRequestsPerClass = 32;
constexpr std::uint8_t kErrorInStartup = 28;  // class of asynchronous errors (S7-BLK-14)

}  // namespace

bool Requests::runsOrWaits(std::uint8_t ob) const {
  const auto same = [&](const auto& one) { return one.ob == ob; };
  return std::any_of(waiting_.begin(), waiting_.end(), same) ||
         std::any_of(machine_.levels.begin(), machine_.levels.end(), same);
}

void Requests::request(const StartInformation& start) {
  const std::uint8_t ob = start[3];
  if (interrupts_.isLocked(ob) || state_.mode() == Mode::Stop) return;
  if (!hasOb(machine_, ob)) return obMissing(start);
  if (!runsOrWaits(ob)) return queue(start);
  constexpr std::uint8_t kStillRunning = 0x02;
  timeError(kStillRunning, loadWord(&start[6]), start);
}

void Requests::queue(StartInformation start) {
  const std::uint8_t ob = start[3];
  if (state_.mode() == Mode::Startup && ob >= 80) start[2] = kErrorInStartup;
  const std::uint8_t priority = start[2];
  const auto same = std::count_if(waiting_.begin(), waiting_.end(),
                                  [&](const Request& r) { return r.priority == priority; });
  constexpr std::uint8_t kOverflow = 0x07;
  if (same >= kRequestsPerClass && ob != 80)
    return timeError(kOverflow, loadWord(&start[6]), start);
  waiting_.push_back({.ob = ob, .priority = priority, .start = start});
  machine_.interrupt();
}

void Requests::timeError(std::uint8_t faultId, std::uint32_t info, const StartInformation& cause) {
  StartInformation start = startInformation(0x35, faultId, priorityOf(80), 80, log_.dateAndTime());
  setWord(start, 6, info);
  std::copy_n(cause.begin(), 4, start.begin() + 8);  // class, number, priority, OB
  asynchronousError(start);
}

// S7-OBI-10: bytes 8 and 9 the event, 10 and 11 who was running.
void Requests::obMissing(const StartInformation& wanted) {
  StartInformation start = startInformation(0x35, 0xA1, priorityOf(85), 85, log_.dateAndTime());
  std::copy_n(wanted.begin() + 6, 2, start.begin() + 6);
  std::copy_n(wanted.begin(), 2, start.begin() + 8);
  setByte(start, 10, runningPriority(machine_));
  setByte(start, 11, runningOb(machine_));
  asynchronousError(start, "OB " + std::to_string(wanted[3]));
}

void Requests::asynchronousError(const StartInformation& start, std::string_view detail) {
  const std::uint8_t ob = start[3];
  std::string words = describe(start);
  if (!detail.empty()) words.append(": ").append(detail);
  log_.report(start, words);
  if (!comesFromModule(ob)) faults_.program = true;
  if (state_.mode() == Mode::Stop || interrupts_.isLocked(ob)) return;  // SFC 39: entered only
  if (hasOb(machine_, ob)) {
    if (ob != 80 || !runsOrWaits(ob))
      queue(start);  // one OB 80 at a time; the entry tells the rest
  } else if (const auto why = stopWithout(ob)) {
    state_.stopByFault(*why, words);
  }
}

void Requests::startHighest() {
  if (waiting_.empty()) return;
  const bool delayed = std::any_of(machine_.levels.begin(), machine_.levels.end(),
                                   [](const Level& level) { return level.delayed > 0; });
  if (delayed) return;  // SFC 41
  const auto highest =
      std::max_element(waiting_.begin(), waiting_.end(),
                       [](const Request& a, const Request& b) { return a.priority < b.priority; });
  if (highest->priority <= runningPriority(machine_)) return;
  if (state_.mode() == Mode::Startup && highest->priority < kErrorInStartup) return;  // S7-STATE-11
  const Request request = *highest;
  waiting_.erase(highest);
  if (!hasOb(machine_, request.ob)) return obMissing(request.start);  // deleted while it waited
  startLevel(machine_, request.ob, request.priority, request.start, false);
}

void Requests::clearErrors() {
  std::erase_if(waiting_, [](const Request& request) { return request.ob >= 80; });
}

}  // namespace merker::cpu
