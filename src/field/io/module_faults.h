// What is wrong with a module: faults that were put there, of itself and of single channels, and
// those that it sees in its values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "io/fault.h"

namespace merker::io {

constexpr std::uint16_t bitOf(FaultKind kind) {
  return static_cast<std::uint16_t>(1u << static_cast<unsigned>(kind));
}

class ModuleFaults {
 public:
  // A fault comes or goes; `channel` only for kinds that have one, none = all channels. False if
  // the module has it already, or has it no more.
  bool put(FaultKind kind, std::optional<std::uint32_t> channel, bool there);
  // What the conversion of a channel shows, as bits. False: the same as before.
  bool see(std::uint32_t channel, std::uint16_t kinds) {
    return std::exchange(seen_[channel], kinds) != kinds;
  }

  bool has(FaultKind kind) const { return hasAny(bitOf(kind)); }  // of the module
  bool hasAny(std::uint16_t kinds) const { return (ofModule_ & kinds) != 0; }
  bool has(std::uint32_t channel, FaultKind kind) const {
    return ((put_[channel] | seen_[channel]) & bitOf(kind)) != 0;
  }
  bool hasAnywhere(FaultKind kind) const;
  // Of an axis: bytes 8 and 9 of data record 1 (POS-DIAG-09, -10).
  void showAxis(std::uint16_t errors) { axis_ = errors; }
  std::uint16_t axis() const { return axis_; }
  std::uint16_t putAt(std::uint32_t channel) const { return put_[channel]; }

 private:
  std::uint16_t ofModule_ = 0;  // bitOf
  std::uint16_t axis_ = 0;
  std::array<std::uint16_t, 32> put_{}, seen_{};
};

}  // namespace merker::io
