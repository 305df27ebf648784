// The connection resources of a CPU: so many in all, one of them kept for a programming device and
// one for a panel (S7-LIM-05).
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace merker::served {

enum class Resource : std::uint8_t { Pg, Op, Basic };

// What a called TSAP asks for: its first byte is 1 PG, 2 OP, or another kind.
Resource resourceOf(std::span<const std::uint8_t> called);

class Resources {
 public:
  static constexpr unsigned kConnections = 12;  // of a CPU 314C-2

  // False: none is free for this kind.
  bool take(Resource kind);
  void release(Resource kind) { --used(kind); }
  unsigned inUse() const;

 private:
  unsigned& used(Resource kind) { return used_[static_cast<std::size_t>(kind)]; }
  unsigned keptFor(Resource kind) const;
  std::array<unsigned, 3> used_{};
};

}  // namespace merker::served
