// Cycles that need not be computed because they are proven to be the same as the one before: time
// and all counters move as if they had been (docs/decisions/0013-quiet-cycles.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plc/capability.h"

namespace merker::controller {

class QuietCycles : public Capability {
 public:
  static constexpr std::string_view kName = "quiet cycles";

  // On from the beginning.
  virtual void passOverQuietCycles(bool on) = 0;
  virtual std::uint64_t cyclesPassedOver() const = 0;

  // Why cycles were computed, the most frequent reason first: "OB 1 reads its date and time
  // (main.awl:12)".
  struct Reason {
    std::string text;
    std::uint64_t cycles = 0;
  };
  virtual std::vector<Reason> whyComputed() const = 0;
};

}  // namespace merker::controller
