#include "cpu/forces.h"

namespace merker::cpu {

void Forces::release(std::uint32_t imageByte, std::uint8_t mask) {
  for (Force& force : list_)
    if (force.byte == imageByte) force.mask = static_cast<std::uint8_t>(force.mask & ~mask);
  std::erase_if(list_, [](const Force& force) { return force.mask == 0; });
}

void Forces::apply(std::span<std::uint8_t> image) const {
  for (const Force& force : list_) {
    std::uint8_t& byte = image[force.byte];
    byte = static_cast<std::uint8_t>((byte & ~force.mask) | (force.value & force.mask));
  }
}

}  // namespace merker::cpu
