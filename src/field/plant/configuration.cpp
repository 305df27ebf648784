#include "plant/configuration.h"

#include "base/text.h"

namespace merker::plant {

const Wire* PlantSettings::wireOf(std::uint32_t signal) const {
  for (const Wire& wire : wires)
    if (wire.signal == signal) return &wire;
  return nullptr;
}

std::optional<std::uint32_t> Configuration::find(std::string_view name) const {
  for (std::uint32_t i = 0; i < plants.size(); ++i)
    if (equalsIgnoreCase(plants[i].name, name)) return i;
  return std::nullopt;
}

std::string Configuration::names() const {
  std::string list;
  for (const PlantSettings& plant : plants) list += (list.empty() ? "" : ", ") + plant.name;
  return list;
}

std::string PlantSettings::driverOf(const io::Terminal& terminal) const {
  for (const Wire& wire : wires) {
    const auto* end = std::get_if<io::Terminal>(&wire.end);
    const Signal& signal = kind->signals[wire.signal];
    if (end != nullptr && *end == terminal && signal.side == Signal::Side::Output)
      return name + '.' + std::string(signal.name);
  }
  return {};
}

std::string Configuration::driverOf(const io::Terminal& terminal) const {
  for (const PlantSettings& plant : plants)
    if (std::string driver = plant.driverOf(terminal); !driver.empty()) return driver;
  for (const LentTerminal& one : lent)
    if (one.terminal == terminal && !io::isOutput(terminal.side)) return one.signal;
  return {};
}

}  // namespace merker::plant
