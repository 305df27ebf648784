// Answers calls of SFC, SFB and of the library functions that the CPU brings.
#pragma once

#include <vector>

#include "block/block.h"
#include "cpu/engine.h"
#include "system/function.h"
#include "system/modules.h"

namespace merker::system {

class Services : public cpu::SystemServices {
 public:
  Services();
  bool call(const cpu::SystemCall& call) override;
  // Whom the functions for modules ask; null: no modules.
  void connect(Modules* modules) { modules_ = modules; }

 private:
  struct Entry {
    const Function* function = nullptr;
    std::vector<BitAddress> places;  // SFB: of the parameters in the instance
  };
  const Entry* find(BlockId id) const;

  Modules* modules_ = nullptr;
  Functions functions_;
  std::vector<Entry> fcs_, sfcs_, sfbs_;  // by number
};

}  // namespace merker::system
