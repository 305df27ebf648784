// The periphery bytes between the modules of a rack and the CPU: which module answers where, what
// the inputs show, what the CPU has written to the outputs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/configuration.h"

namespace merker::io {

// Modules, as indices in the configuration, by the bytes where they answer.
class Owners {
 public:
  explicit Owners(std::size_t bytes) : owners_(bytes, kNobody) {}
  void add(std::optional<std::uint32_t> start, unsigned count, std::size_t module);
  std::optional<std::uint32_t> at(std::uint32_t byte) const;

 private:
  static constexpr std::uint16_t kNobody = 0xFFFF;
  std::vector<std::uint16_t> owners_;
};

struct Bytes {
  std::uint32_t first = 0, count = 0;
};

class InputBytes {
 public:
  explicit InputBytes(const Configuration& configuration);

  std::optional<std::uint32_t> owner(std::uint32_t byte) const { return owners_.at(byte); }
  const std::vector<std::uint8_t>& all() const { return bytes_; }
  void set(std::uint32_t byte, std::uint8_t value);
  bool changed() const { return first_ <= last_; }
  bool changedBefore(std::uint32_t byte) const { return changed() && first_ < byte; }
  Bytes takeChanged();

 private:
  Owners owners_;
  std::vector<std::uint8_t> bytes_;
  std::uint32_t first_ = UINT32_MAX, last_ = 0;  // that changed
};

class OutputBytes {
 public:
  explicit OutputBytes(const Configuration& configuration);

  std::optional<std::uint32_t> owner(std::uint32_t byte) const { return owners_.at(byte); }
  void write(std::uint32_t first, const std::uint8_t* bytes, std::uint32_t count);
  void disable(bool disabled);
  void supply(bool on);
  bool disabled() const { return disabled_; }
  bool supplied() const { return supplied_; }
  // As the CPU wrote them; disabled ones as they were when they were disabled.
  std::uint8_t byte(std::uint32_t byte) const { return (disabled_ ? kept_ : written_)[byte]; }
  std::uint16_t word(std::uint32_t byte) const;

 private:
  Owners owners_;
  std::vector<std::uint8_t> written_, kept_;
  bool disabled_ = true, supplied_ = true;
};

}  // namespace merker::io
