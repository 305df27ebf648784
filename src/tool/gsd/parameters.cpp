#include "gsd/parameters.h"

#include <algorithm>

#include "base/text.h"

namespace merker::gsd {
namespace {

constexpr std::size_t kLongest = 244;  // bytes of a parameter telegram

void atLeast(Bytes& bytes, std::size_t length) {
  if (bytes.size() < length) bytes.resize(std::min(length, kLongest));
}

std::size_t widthOf(const Parameter& parameter) {
  if (parameter.type.ends_with("32")) return 4;
  return parameter.type.ends_with("16") ? 2 : 1;
}

// The highest byte first; bits only where they belong.
void put(Bytes& bytes, std::size_t offset, const Parameter& parameter) {
  const std::size_t width = widthOf(parameter);
  atLeast(bytes, offset + width);
  if (bytes.size() < offset + width) return;
  auto value = static_cast<std::uint64_t>(parameter.standard);
  if (equalsIgnoreCase(parameter.type.substr(0, 3), "Bit")) {
    const std::uint32_t count = parameter.lastBit - parameter.firstBit + 1;
    const std::uint32_t mask = ((1u << count) - 1u) << parameter.firstBit;
    bytes[offset] = static_cast<std::uint8_t>(
        (bytes[offset] & ~mask) |
        ((static_cast<std::uint32_t>(value) << parameter.firstBit) & mask));
    return;
  }
  for (std::size_t i = width; i-- > 0; value >>= 8)
    bytes[offset + i] = static_cast<std::uint8_t>(value);
}

}  // namespace

Bytes standardParameters(const UserParameters& parameters, const Device& device) {
  Bytes made;
  atLeast(made, parameters.length);
  for (const auto& fixed : parameters.fixed) {
    atLeast(made, fixed.offset + fixed.bytes.size());
    for (std::size_t i = 0; i < fixed.bytes.size() && fixed.offset + i < made.size(); ++i)
      made[fixed.offset + i] = fixed.bytes[i];
  }
  for (const auto& reference : parameters.references) {
    const auto found =
        std::ranges::find(device.definitions, reference.parameter, &Parameter::number);
    if (found != device.definitions.end()) put(made, reference.offset, *found);
  }
  return made;
}

}  // namespace merker::gsd
