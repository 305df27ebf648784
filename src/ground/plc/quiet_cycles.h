// Cycles that need not be computed because they are proven to be the same as the one before: time
// and all counters move as if they had been (docs/decisions/0013-quiet-cycles.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "address/block_id.h"
#include "plc/capability.h"

namespace merker::controller {

class QuietCycles : public Capability {
 public:
  static constexpr std::string_view kName = "quiet cycles";

  // On from the beginning.
  virtual void passOverQuietCycles(bool on) = 0;
  virtual std::uint64_t cyclesPassedOver() const = 0;

  // Why cycles were computed, the most frequent reason first. Each computed cycle counts once, but
  // for those at whose ends nobody asked.
  struct Reason {
    std::string text;  // "OB 1 reads the date and time of OB 1"
    std::uint64_t cycles = 0;
    // The instruction, where one is known.
    struct Place {
      BlockId block;
      std::uint32_t offset = 0;
    };
    std::optional<Place> place{};
    std::string changed{};  // operand: "MB 11", "DB10.DBB 4"
  };
  virtual std::vector<Reason> whyComputed() const = 0;
};

}  // namespace merker::controller
