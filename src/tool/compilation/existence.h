// Whether the operands that a user names exist in the CPU, as far as that is known before it runs.
#pragma once

#include <memory>
#include <optional>

#include "address/reference.h"
#include "block/block.h"
#include "station/station.h"

namespace merker::compilation {

class Existence {
 public:
  // A station that is not started yet, with its program loaded.
  explicit Existence(station::Station station) : station_(std::move(station)) {}
  // The problem if the operand is not there. A data block that is missing may still come where the
  // program makes some (SFC 22).
  std::optional<Problem> problem(const address::Reference& reference, const Position& at) const;

 private:
  bool makesDataBlocks() const;
  station::Station station_;
};

// Whether it can be read now.
bool exists(const address::Reference& reference, const controller::Controller& plc);
}  // namespace merker::compilation
