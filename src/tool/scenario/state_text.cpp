#include "scenario/state_text.h"

#include <array>

#include "plc/stop_screens.h"

namespace merker::simulator {

using controller::Controller;
using controller::Mode;

std::string_view modeName(Mode mode) {
  constexpr std::array<std::string_view, 4> kModes = {"STOP", "STARTUP", "RUN", "HALT"};
  return kModes[static_cast<std::size_t>(mode)];
}

std::string stopText(const Controller& plc) {
  const auto* screens = controller::capability<controller::StopScreens>(plc);
  const std::string details = screens == nullptr ? "" : screens->stopDetails();
  return plc.stopReason() + (details.empty() ? "" : "; " + details);
}

std::string because(const Controller& plc) {
  const std::string reason = plc.stopReason();
  return reason.empty() ? reason : ": " + reason;
}

}  // namespace merker::simulator
