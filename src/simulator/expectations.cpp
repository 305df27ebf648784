#include "simulator/expectations.h"

#include <fmt/format.h>

#include <array>

#include "base/text.h"
#include "controller/stop_screens.h"
#include "simulator/comparison.h"
#include "simulator/long_value.h"
#include "station/station.h"

namespace merker::simulator {
namespace {

using controller::Controller;
using controller::Mode;
using station::Station;

bool containsIgnoreCase(std::string_view text, std::string_view part) {
  return upper(text).find(upper(part)) != std::string::npos;
}

Reader reader(const Controller& plc) {
  return [&plc](const address::Reference& reference) { return plc.read(reference); };
}

bool inDiagnostics(const Controller& plc, const std::string& words) {
  for (const auto& entry : plc.diagnostics())
    if (containsIgnoreCase(fmt::format("16#{:04X} {}", entry.event, entry.text), words))
      return true;
  return false;
}

std::string newestEntry(const Controller& plc) {
  if (plc.diagnostics().empty()) return "the diagnostic buffer is empty";
  const auto& last = plc.diagnostics().back();
  return fmt::format("the newest entry is 16#{:04X} {}", last.event, last.text);
}

}  // namespace

std::string_view modeName(Mode mode) {
  constexpr std::array<std::string_view, 4> kNames = {"STOP", "STARTUP", "RUN", "HALT"};
  return kNames[static_cast<std::size_t>(mode)];
}

std::string stopText(const Controller& plc) {
  const auto* screens = dynamic_cast<const controller::StopScreens*>(&plc);
  const std::string details = screens == nullptr ? "" : screens->stopDetails();
  return plc.stopReason() + (details.empty() ? "" : "; " + details);
}

std::string because(const Controller& plc) {
  const std::string reason = plc.stopReason();
  return reason.empty() ? reason : ": " + reason;
}

bool needsDevice(const Expectation& e) {
  return e.what == Expectation::What::Led || e.what == Expectation::What::Terminal ||
         e.what == Expectation::What::Plant;
}

// Values are those at the end of a cycle: in the middle of one they may be on their way.
bool holds(const Expectation& e, Controller& own) {
  Controller& plc = e.partner && own.partner() != nullptr ? *own.partner() : own;
  const Station* device = dynamic_cast<const Station*>(&plc);
  switch (e.what) {
    case Expectation::What::Values:
      plc.settle();
      if (isLong(e.left)) return longHolds(e.left, e.relation, e.right, plc);
      return simulator::holds(e.left, e.relation, e.right, reader(plc));
    case Expectation::What::Mode:
      return (plc.mode() == e.mode) == (e.relation == block::Relation::Equal);
    case Expectation::What::Diagnostics:
      return inDiagnostics(plc, e.words);
    case Expectation::What::Terminal:
      plc.settle();
      return simulator::holds(e.terminal, e.relation, *device->rack());
    case Expectation::What::Plant:
      return simulator::holds(e.plant, e.relation, *device->plants());
    case Expectation::What::Stack:
      return simulator::holds(e.stack, e.relation, plc);
    case Expectation::What::Led:
      return (device->leds().*e.led == e.light) == (e.relation == block::Relation::Equal);
  }
  return false;
}

// What is there instead.
std::string actual(const Expectation& e, Controller& own) {
  const Controller& plc = e.partner && own.partner() != nullptr ? *own.partner() : own;
  const Station* device = dynamic_cast<const Station*>(&plc);
  const bool stopped = plc.mode() == Mode::Stop;
  switch (e.what) {
    case Expectation::What::Values:
      return fmt::format("{} is {}", e.left.text,
                         isLong(e.left) ? actualLong(e.left, e.right, plc)
                                        : actualValue(e.left, e.right, reader(plc))) +
             (stopped ? fmt::format(" (the CPU is in STOP{})", because(plc)) : "");
    case Expectation::What::Mode:
      return fmt::format("mode is {}{}", modeName(plc.mode()), because(plc));
    case Expectation::What::Diagnostics:
      return newestEntry(plc);
    case Expectation::What::Terminal:
      return fmt::format("{} is {}", e.terminal.text,
                         simulator::actualValue(e.terminal, *device->rack()));
    case Expectation::What::Plant:
      return fmt::format("{} is {}", e.plant.text,
                         simulator::actualValue(e.plant, *device->plants()));
    case Expectation::What::Stack:
      return simulator::actualValue(e.stack, plc);
    case Expectation::What::Led:
      return fmt::format("it is {}", simulator::name(device->leds().*e.led));
  }
  return {};
}

}  // namespace merker::simulator
