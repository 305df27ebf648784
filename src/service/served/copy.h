// What is copied at each end of a cycle for readers that do not wait for the PLC: all operands, and
// of the periphery what clients have been asking for.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plc/controller.h"
#include "plc/operand_memory.h"
#include "s7comm/range.h"

namespace merker::served {

struct Copy {
  controller::OperandImage operands;
  std::vector<std::pair<s7comm::Range, s7comm::Value>> periphery;
};

// Nothing: a range of the periphery is not in the copy.
std::optional<std::vector<s7comm::Value>> valuesOf(const Copy& copy,
                                                   std::span<const s7comm::Range> ranges);

// The ranges of the periphery that are copied: those that were asked for in the last ten seconds
// of the PLC's time. Only modules know their values, so that all of them are not copied each cycle.
class PeripheryWatch {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr Duration kKept = Duration::seconds(10);

  // A range that does not fit any more is read by an order each time.
  void ask(std::span<const s7comm::Range> ranges);
  // Of the end of a cycle.
  void copy(const controller::Controller& plc, Copy& copy);

 private:
  struct Asked {
    s7comm::Range range;
    std::optional<Instant> last{};  // nothing: since the last copy
  };
  std::vector<Asked> asked_;
};

}  // namespace merker::served
