// Steps that work on the CPU as a device: switch positions, events made by hand, LEDs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cpu/leds.h"
#include "cpu/mode_switch.h"
#include "cpu/trigger.h"

namespace merker::simulator {

// "RUN-P", ignoring case.
std::optional<cpu::SwitchPosition> parseSwitch(std::string_view word);

// "OB 82 coming address 256 data DW#16#05000000". Else `wrong` is the part that is not understood,
// and the text says what is expected there.
struct ParsedTrigger {
  cpu::Trigger trigger{};
  std::string_view wrong{};
  std::string expected{};
};
ParsedTrigger parseTrigger(std::string_view text);

using LedMember = cpu::Light cpu::Leds::*;
LedMember parseLed(std::string_view name);  // null if there is none
std::optional<cpu::Light> parseLight(std::string_view word);
std::string_view name(cpu::Light light);

}  // namespace merker::simulator
