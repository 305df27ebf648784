#include "io/terminal.h"

#include <array>
#include <charconv>

#include "base/text.h"

namespace merker::io {
namespace {

struct SideName {
  std::string_view letters;
  Side side;
};
constexpr std::array kSides = {
    SideName{"DI", Side::DigitalInput}, SideName{"DO", Side::DigitalOutput},
    SideName{"AI", Side::AnalogInput}, SideName{"AO", Side::AnalogOutput}};

}  // namespace

std::optional<TerminalName> parseTerminal(std::string_view text) {
  const auto point = text.rfind('.');
  if (point == std::string_view::npos || point == 0) return std::nullopt;
  TerminalName name{text.substr(0, point)};
  if (name.module.size() >= 2 && name.module.front() == '"' && name.module.back() == '"')
    name.module = name.module.substr(1, name.module.size() - 2);
  const std::string_view channel = text.substr(point + 1);
  if (channel.size() < 3) return std::nullopt;
  const char* end = channel.data() + channel.size();
  const auto [stop, error] = std::from_chars(channel.data() + 2, end, name.channel);
  if (error != std::errc() || stop != end) return std::nullopt;
  for (const SideName& row : kSides) {
    if (!equalsIgnoreCase(channel.substr(0, 2), row.letters)) continue;
    name.side = row.side;
    return name;
  }
  return std::nullopt;
}

}  // namespace merker::io
