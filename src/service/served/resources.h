// The connection resources of a CPU: so many in all, some of them kept for programming devices,
// panels and S7 basic communication (S7-LIM-05).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "catalogue/communication.h"

namespace merker::served {

enum class Resource : std::uint8_t { Pg, Op, Basic };

// What a called TSAP asks for: its first byte is 1 PG, 2 OP, or another kind.
Resource resourceOf(std::span<const std::uint8_t> called);
// The second byte is rack * 32 + slot: the CPU is in slot 2 of rack 0.
bool namesTheCpu(std::span<const std::uint8_t> called);

class Resources {
 public:
  using Counts = std::array<std::uint32_t, 3>;  // by kind

  // Those in use stay, whatever the limits are from now on.
  void limit(const CommunicationParameters& parameters);
  // False: none is free for this kind.
  bool take(Resource kind);
  void release(Resource kind) { --used(kind); }
  unsigned inUse() const;
  const Counts& counts() const { return used_; }

 private:
  std::uint32_t& used(Resource kind) { return used_[static_cast<std::size_t>(kind)]; }
  std::optional<std::uint32_t> connections_ = ConnectionLimits{}.connections;
  Counts reserved_{1, 1, 0}, used_{};
};

}  // namespace merker::served
