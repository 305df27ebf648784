#include <algorithm>
#include <array>

#include "base/text.h"
#include "plant/kind.h"
#include "plant/processes.h"

namespace merker::plant {
namespace {

constexpr std::array kKinds{&kFirstOrder, &kTemperature,    &kValve,        &kTank,
                            &kGenerator,  &kBouncingSwitch, &kSortingPlant, &kVessel,
                            &kGarageDoor, &kTrafficLight,   &kLift,         &kPulseTrain,
                            &kEncoder,    &kAxis,           &kSpeedDrive,   &kPositioningDrive};

template <typename Rows, typename Name>
std::string list(const Rows& rows, Name name) {
  std::string text;
  for (const auto& row : rows) text += (text.empty() ? "" : ", ") + std::string(name(row));
  return text;
}

}  // namespace

std::span<const Kind* const> kinds() { return kKinds; }

const Kind* findKind(std::string_view name) {
  const auto* found = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind* kind) {
    return equalsIgnoreCase(kind->name, name);
  });
  return found == kKinds.end() ? nullptr : *found;
}

std::string kindNames() {
  return list(kKinds, [](const Kind* kind) { return kind->name; });
}

std::string signalNames(const Kind& kind) {
  return list(kind.signals, [](const Signal& signal) { return signal.name; });
}

std::optional<std::uint32_t> Kind::signal(std::string_view wanted) const {
  for (std::uint32_t i = 0; i < signals.size(); ++i)
    if (equalsIgnoreCase(signals[i].name, wanted)) return i;
  return std::nullopt;
}

}  // namespace merker::plant
