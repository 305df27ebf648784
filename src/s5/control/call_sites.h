// The calls of a program as compiled code follows them: each with the block that it enters and the
// frame that the processor would push for it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jit/blocks.h"
#include "lowering5/translate.h"
#include "softplc/processor.h"

namespace merker::cnc {

struct Call {
  mc5::BlockId block;
  std::uint32_t start = 0;       // word of segment 5 where the block begins
  std::uint32_t parameters = 0;  // word of the list behind the call of an FB
  std::uint32_t next = 0;        // word behind the call
};

class CallSites {
 public:
  void clear();
  // The calls in a block of code. What leads into a function macro or a missing block is none.
  translate5::Sites add(const sinumerik::BlockMemory& blocks, const sinumerik::Entry& block,
                        const sinumerik::Environment& environment);

  std::span<const Call> calls() const { return calls_; }
  jit::Site& site(std::size_t number) { return sites_[number]; }
  const jit::Site* sites() const { return sites_.data(); }
  // Null: it was not pushed by one of these.
  const Call* find(const jit::Site* site) const;

 private:
  std::vector<Call> calls_;
  std::vector<jit::Site> sites_;  // one for each, in machine code's own layout
};

}  // namespace merker::cnc
