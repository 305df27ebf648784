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

}  // namespace merker::plant
