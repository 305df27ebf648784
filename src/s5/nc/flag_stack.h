// FB 65 M STACK and FB 66 STACK M: MB 224 … 255 saved and brought back (S5-FM-48, -49).
#pragma once

#include <array>
#include <vector>

#include "nc/macro_error.h"
#include "nc/plc_memory.h"

namespace merker::nc {

class FlagStack {
 public:
  explicit FlagStack(unsigned depth) : depth_(depth) {}

  Error push(const sinumerik::Machine& machine);
  Error pop(sinumerik::Machine& machine);
  void clear() { saved_.clear(); }

 private:
  using Flags = std::array<std::uint8_t, sinumerik::kFlagBytes - kFirstTransferFlag>;
  unsigned depth_;
  std::vector<Flags> saved_;  // innermost last
};

}  // namespace merker::nc
