#include "scenario/expectations/values.h"

#include <fmt/format.h>

#include "scenario/comparison.h"
#include "scenario/long_value.h"
#include "scenario/state_text.h"

namespace merker::simulator::expectations {
namespace {

Reader readerOf(const controller::Controller& plc) {
  return [&plc](const address::Reference& reference) { return plc.read(reference); };
}

}  // namespace

// The time of a timer runs, and analog inputs follow their plants beside the cycles.
std::optional<Instant> Values::staysUntil(const controller::Controller&) const {
  const auto stays = [](const Term& term) {
    const address::Operand& operand = term.reference.operand;
    return term.constant ||
           (!isTimer(operand) && operand.area != Area::Peripheral && !term.reference.partner);
  };
  return stays(left) && stays(right) ? std::optional(Instant::never()) : std::nullopt;
}

// Values are those at the end of a cycle: in the middle of one they may be on their way.
bool Values::holds(controller::Controller& plc) const {
  plc.settle();
  return isLong(left) ? longHolds(left, relation, right, plc)
                      : simulator::holds(left, relation, right, readerOf(plc));
}

std::string Values::actual(controller::Controller& plc) const {
  const std::string value =
      isLong(left) ? actualLong(left, right, plc) : actualValue(left, right, readerOf(plc));
  const bool stopped = plc.mode() == controller::Mode::Stop;
  return fmt::format("{} is {}", left.text, value) +
         (stopped ? fmt::format(" (the CPU is in STOP{})", because(plc)) : "");
}

}  // namespace merker::simulator::expectations
