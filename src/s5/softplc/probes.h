// Which code blocks somebody looks at, by the words of segment 5.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "softplc/probe.h"
#include "softplc/processor.h"

namespace merker::sinumerik {

// By block; a probe outlives its place here.
using PlacedProbes = std::map<mc5::BlockId, Probe*>;

class Probes {
 public:
  // null: none any more. The block may come later or again.
  void place(mc5::BlockId block, Probe* probe);
  const PlacedProbes& placed() const { return placed_; }
  bool any() const { return !placed_.empty(); }

  // Whether the next instruction is not to be executed.
  bool before(const Machine& machine);
  void after(const Processor& processor, Outcome outcome);
  // All words of the blocks that are looked at.
  void addTo(std::vector<bool>& words, const BlockMemory& blocks);

 private:
  struct Watched {
    mc5::BlockId block;
    std::uint32_t start = 0, length = 0;
    Probe* probe = nullptr;
  };
  void attach(const BlockMemory& blocks);
  void attachTo(const Watched& watched, const std::vector<std::uint16_t>& program);

  PlacedProbes placed_;
  std::vector<Watched> watched_;
  std::vector<std::uint16_t> byWord_;          // of segment 5: number in watched_ from 1 on, 0 none
  std::uint64_t version_ = ~std::uint64_t{0};  // of the code that these know
  Probe* asked_ = nullptr;                     // about the instruction at now_
  CodePlace now_;
};

}  // namespace merker::sinumerik
