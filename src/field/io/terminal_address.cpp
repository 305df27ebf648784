#include "io/terminal_address.h"

#include <charconv>

#include "base/text.h"
#include "io/asi.h"

namespace merker::io {
namespace {

struct Letters {
  std::string_view german, english;
  Side side;
};
constexpr Letters kLetters[] = {
    {"E", "I", Side::DigitalInput},    {"A", "Q", Side::DigitalOutput},
    {"EW", "IW", Side::AnalogInput},   {"AW", "QW", Side::AnalogOutput},
    {"PEW", "PIW", Side::AnalogInput}, {"PAW", "PQW", Side::AnalogOutput}};

std::optional<std::uint32_t> number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Channel of a module of the racks or of a DP slave.
std::optional<std::uint32_t> channelOf(const Module& module, const TerminalAddress& address) {
  const bool output = isOutput(address.side), digital = isDigital(address.side);
  const auto& start = output ? module.outputStart : module.inputStart;
  if (!start || address.byte < *start) return std::nullopt;
  const std::uint32_t offset = address.byte - *start;
  if (!digital && offset % 2 != 0) return std::nullopt;
  const std::uint32_t channel = digital ? 8 * offset + address.bit : offset / 2;
  const ModuleType& type = *module.type;
  const std::uint32_t count = digital ? (output ? type.digitalOutputs : type.digitalInputs)
                                      : (output ? type.analogOutputs : type.analogInputs);
  return channel < count ? std::optional(channel) : std::nullopt;
}

// The four bits of an AS-i slave among the bytes of its CP.
std::optional<std::uint32_t> channelOf(const Module& slave, const Module& cp,
                                       const TerminalAddress& address) {
  const auto& start = isOutput(address.side) ? cp.outputStart : cp.inputStart;
  const std::uint32_t shift = asiShift(slave.slot);
  if (!isDigital(address.side) || address.byte != start.value_or(0) + asiByte(slave.slot) ||
      address.bit < shift || address.bit >= shift + kAsiBits)
    return std::nullopt;
  return address.bit - shift;
}

}  // namespace

std::optional<TerminalAddress> parseTerminalAddress(std::string_view text) {
  const auto blank = text.find(' ');
  if (blank == std::string_view::npos) return std::nullopt;
  const std::string_view letters = text.substr(0, blank), rest = trim(text.substr(blank));
  for (const Letters& row : kLetters) {
    if (!equalsIgnoreCase(letters, row.german) && !equalsIgnoreCase(letters, row.english)) continue;
    const auto point = rest.find('.');
    const auto byte = number(rest.substr(0, point));
    if (!byte || isDigital(row.side) != (point != std::string_view::npos)) return std::nullopt;
    if (!isDigital(row.side)) return TerminalAddress{row.side, *byte};
    const auto bit = number(rest.substr(point + 1));
    if (!bit || *bit > 7) return std::nullopt;
    return TerminalAddress{row.side, *byte, *bit};
  }
  return std::nullopt;
}

std::optional<Terminal> terminalAt(const Configuration& configuration,
                                   const TerminalAddress& address) {
  const std::vector<Module>& modules = configuration.modules;
  for (std::uint32_t i = 0; i < modules.size(); ++i) {
    const auto channel = modules[i].asiCp
                             ? channelOf(modules[i], modules[*modules[i].asiCp], address)
                             : channelOf(modules[i], address);
    if (channel) return Terminal{i, address.side, *channel};
  }
  return std::nullopt;
}

}  // namespace merker::io
