// Signal connections of modules: as numbers, and as merker.toml and scenarios name them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace merker::io {

// A signal connection: channel of a module, counted from 0 separately for digital inputs, digital
// outputs, analog inputs and analog outputs.
enum class Side : std::uint8_t { DigitalInput, DigitalOutput, AnalogInput, AnalogOutput };
struct Terminal {
  std::uint32_t module = 0;  // index in Configuration::modules
  Side side = Side::DigitalInput;
  std::uint32_t channel = 0;
  bool operator==(const Terminal&) const = default;
};

constexpr bool isDigital(Side side) {
  return side == Side::DigitalInput || side == Side::DigitalOutput;
}
constexpr bool isOutput(Side side) {
  return side == Side::DigitalOutput || side == Side::AnalogOutput;
}

// Panel.DI3, "Fill level".AI0; the module is a view into the text, without quotation marks.
struct TerminalName {
  std::string_view module;
  Side side = Side::DigitalInput;
  std::uint32_t channel = 0;
};
std::optional<TerminalName> parseTerminal(std::string_view text);

}  // namespace merker::io
