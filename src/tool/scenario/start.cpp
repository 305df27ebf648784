#include "scenario/start.h"

#include <algorithm>

#include "plc/capability.h"
#include "scenario/state_text.h"

namespace merker::simulator {

using controller::Controller;
using controller::Mode;

static void finishStartup(Controller& plc, Duration longest) {
  const Instant limit = plc.now() + longest;
  while (plc.mode() == Mode::Startup && plc.now() < limit) advanceToNextLook(plc, limit);
}

bool restart(Controller& plc, Start how, Duration longest) {
  if (plc.mode() != Mode::Stop) plc.stop();
  if (!(plc.*how)()) return false;
  finishStartup(plc, longest);
  return true;
}

std::vector<std::string> refusals(const std::vector<NamedPlc>& plcs, Duration longest) {
  std::vector<std::string> reasons(plcs.size());
  for (const NamedPlc& one : plcs) {
    if (one.plc->mode() != Mode::Stop) one.plc->stop();
    one.plc->memoryReset();
  }
  for (std::size_t i = 0; i < plcs.size(); ++i)
    if (!plcs[i].plc->start()) reasons[i] = "the CPU does not start" + because(*plcs[i].plc);
  for (std::size_t i = 0; i < plcs.size(); ++i) {
    finishStartup(*plcs[i].plc, longest);
    if (reasons[i].empty() && plcs[i].plc->mode() == Mode::Startup)
      reasons[i] = "the CPU does not reach RUN";
  }
  return reasons;
}

std::string refusal(Controller& plc, Duration longest) {
  return refusals({NamedPlc{{}, &plc}}, longest).front();
}

// A STOP inside a call lets time run to the end of that call, so calls are short; in STOP nothing
// happens any more, unless others go on.
void advanceToNextLook(Controller& plc, Instant end) {
  constexpr Duration kSlice = Duration::milliseconds(1);
  const bool alone = &plc.itself() == &plc;
  const bool stopped = alone && plc.mode() == Mode::Stop;
  plc.advanceToCheckpoint(stopped ? end : std::min(end, plc.now() + kSlice));
}

std::string startFresh(Controller& plc, Duration longest) {
  const std::string reason = refusal(plc, longest);
  if (!reason.empty() || plc.mode() == Mode::Run) return reason;
  return "the CPU does not reach RUN" + because(plc);
}

}  // namespace merker::simulator
