// A copy of a block and its code, for those who outlive the block.
#pragma once

#include <memory>

#include "monitor/code.h"

namespace merker::monitor {

class KeptCode {
 public:
  explicit KeptCode(const BlockCode& code)
      : s7_(code.s7() == nullptr ? nullptr : std::make_shared<const block::Block>(*code.s7())),
        s5_(code.s5() == nullptr ? nullptr : std::make_shared<const mc5::Block>(*code.s5())),
        code_(s7_ ? BlockCode(*s7_) : BlockCode(*s5_)) {}

  const BlockCode& code() const { return code_; }

 private:
  std::shared_ptr<const block::Block> s7_;
  std::shared_ptr<const mc5::Block> s5_;
  BlockCode code_;
};

}  // namespace merker::monitor
