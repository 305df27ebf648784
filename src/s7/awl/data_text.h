// The actual values of a data block as assignments.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "block/block.h"

namespace merker::awl {

struct Assignments {
  std::string text;                  // "a.b[2] := 5;", a line for each element
  std::vector<std::string> without;  // elements whose value no constant says
};

// Each element whose value is not the one that `declared` has there. No constant has a POINTER, an
// ANY, nor a DATE_AND_TIME whose bytes are no date; they get what they have in `before`.
Assignments assignments(const block::Block& declared, std::span<const std::uint8_t> actual,
                        std::span<const std::uint8_t> before = {});

}  // namespace merker::awl
