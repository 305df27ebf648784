// What the program has looked at besides its memory since the last cycle ended, and how long that
// stays as it was. A cycle that looked at nothing of the kind comes to the same again
// (quiet_cycles.h).
#pragma once

#include <cstdint>

#include "address/block_id.h"
#include "clock/instant.h"

namespace merker::cpu {

// What a program can come to something else by, and where it looks.
struct Look {
  enum class At : std::uint8_t { Nothing, Date, Timer, SystemBlock, Error, Output };
  At at = At::Nothing;
  BlockId block{};           // whose instruction looks
  std::uint32_t offset = 0;  // of it; kUnknown: somewhere in the block
  std::uint32_t number = 0;  // of the timer, address of the output
  BlockId called{};          // the system block
  static constexpr std::uint32_t kUnknown = UINT32_MAX;
};

class Outlook {
 public:
  void begin() { *this = {}; }
  // The earliest counts.
  void until(Instant when, const Look& look) {
    if (when >= holds_) return;
    holds_ = when;
    look_ = look;
  }
  // It reads inputs behind the process image.
  void access() { access_ = true; }
  bool accesses() const { return access_; }
  Instant holds() const { return holds_; }
  const Look& look() const { return look_; }

 private:
  Instant holds_ = Instant::never();
  Look look_;
  bool access_ = false;
};

}  // namespace merker::cpu
