#include "io/periphery_bytes.h"

#include <algorithm>
#include <utility>

#include "base/bytes.h"

namespace merker::io {

void Owners::add(std::optional<std::uint32_t> start, unsigned count, std::size_t module) {
  if (!start) return;
  for (std::uint32_t i = *start; i < *start + count && i < owners_.size(); ++i)
    owners_[i] = static_cast<std::uint16_t>(module);
}

std::optional<std::uint32_t> Owners::at(std::uint32_t byte) const {
  if (byte >= owners_.size() || owners_[byte] == kNobody) return std::nullopt;
  return owners_[byte];
}

InputBytes::InputBytes(const Configuration& configuration)
    : owners_(configuration.model->peripheralBytes), bytes_(configuration.model->peripheralBytes) {
  for (std::size_t i = 0; i < configuration.modules.size(); ++i) {
    const Module& module = configuration.modules[i];
    owners_.add(module.inputStart, module.type->inputBytes, i);
  }
}

void InputBytes::set(std::uint32_t byte, std::uint8_t value) {
  if (bytes_[byte] == value) return;
  bytes_[byte] = value;
  first_ = std::min(first_, byte);
  last_ = std::max(last_, byte);
}

Bytes InputBytes::takeChanged() {
  const bool any = changed();
  const std::uint32_t first = std::exchange(first_, UINT32_MAX), last = std::exchange(last_, 0);
  return any ? Bytes{first, last - first + 1} : Bytes{};
}

OutputBytes::OutputBytes(const Configuration& configuration)
    : owners_(configuration.model->peripheralBytes),
      written_(configuration.model->peripheralBytes),
      kept_(configuration.model->peripheralBytes) {
  for (std::size_t i = 0; i < configuration.modules.size(); ++i) {
    const Module& module = configuration.modules[i];
    owners_.add(module.outputStart, module.type->outputBytes, i);
  }
}

void OutputBytes::write(std::uint32_t first, const std::uint8_t* bytes, std::uint32_t count) {
  if (first >= written_.size()) return;
  std::copy_n(bytes, std::min<std::size_t>(count, written_.size() - first),
              written_.begin() + first);
}

void OutputBytes::disable(bool disabled) {
  if (disabled && !disabled_) kept_ = written_;
  disabled_ = disabled;
}

// What an output kept is gone with the supply (S7-STATE-02).
void OutputBytes::supply(bool on) {
  supplied_ = on;
  if (!on) std::ranges::fill(kept_, std::uint8_t{0});
}

std::uint16_t OutputBytes::word(std::uint32_t byte) const {
  return loadWord(&(disabled_ ? kept_ : written_)[byte]);
}

}  // namespace merker::io
