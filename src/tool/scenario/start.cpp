#include "scenario/start.h"

#include <algorithm>

#include "scenario/state_text.h"

namespace merker::simulator {

using controller::Controller;
using controller::Mode;

bool restart(Controller& plc, Start how, Duration longest) {
  if (plc.mode() != Mode::Stop) plc.stop();
  if (!(plc.*how)()) return false;
  const Instant limit = plc.now() + longest;
  while (plc.mode() == Mode::Startup && plc.now() < limit) advanceToNextLook(plc, limit);
  return true;
}

std::string refusal(Controller& plc, Duration longest) {
  if (plc.mode() != Mode::Stop) plc.stop();
  plc.memoryReset();
  if (!restart(plc, &Controller::start, longest)) return "the CPU does not start" + because(plc);
  return plc.mode() == Mode::Startup ? "the CPU does not reach RUN" : std::string();
}

// A STOP inside a call lets time run to the end of that call, so calls are short; in STOP nothing
// happens any more.
void advanceToNextLook(Controller& plc, Instant end) {
  constexpr Duration kSlice = Duration::milliseconds(1);
  const bool stopped = plc.mode() == Mode::Stop;
  plc.advanceToCheckpoint(stopped ? end : std::min(end, plc.now() + kSlice));
}

std::string startFresh(Controller& plc, Duration longest) {
  const std::string reason = refusal(plc, longest);
  if (!reason.empty() || plc.mode() == Mode::Run) return reason;
  return "the CPU does not reach RUN" + because(plc);
}

}  // namespace merker::simulator
