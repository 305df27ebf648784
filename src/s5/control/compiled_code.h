// The code blocks of a PLC as machine code of this computer: filled into the seam of `softplc`.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "control/call_sites.h"
#include "control/seat.h"
#include "jit/native.h"
#include "lowering5/translate.h"
#include "softplc/engine.h"

namespace merker::cnc {

class CompiledCode : public sinumerik::Engine {
 public:
  explicit CompiledCode(jit::Options options = {}) : options_(options) {}

  void compile(sinumerik::Machine& machine, const sinumerik::Environment& environment,
               const std::vector<bool>& apart) override;
  std::uint64_t run(sinumerik::Machine& machine, Instant horizon) override;
  std::size_t bytes() const;  // of machine code
  // What ran compiled so far.
  std::uint64_t instructions() const { return instructions_; }

 private:
  // A word of segment 5 where a region begins.
  struct Entry {
    const jit::NativeCode* code = nullptr;
    std::uint32_t start = 0;  // of the block
  };
  // A function block for one of its calls.
  struct Variant {
    std::uint32_t start = 0;  // of the block
    std::vector<Entry> entries;
  };
  // What the blocks are compiled for, and the calls in them by where they begin.
  struct Plan {
    const sinumerik::Machine& machine;
    const sinumerik::Environment& environment;
    const std::vector<bool>& apart;
    bool linked;  // calls lead from block to block
    std::map<std::uint32_t, translate5::Sites> sites{};
  };
  void clear(const sinumerik::Machine& machine);
  std::unique_ptr<jit::NativeCode> write(const Plan& plan, std::span<const icode::Region> regions,
                                         std::size_t words) const;
  void compileBlock(const Plan& plan, const sinumerik::Entry& block,
                    const translate5::Substitutes& substitutes, std::span<Entry> entries);
  void compileCall(const Plan& plan, const Call& call);
  void linkCalls();

  const Entry& entryAt(const sinumerik::Frame& frame) const;
  void listDataBlocks(sinumerik::Machine& machine);
  void takeIn(sinumerik::Machine& machine, Instant horizon);
  void takeStack(sinumerik::Machine& machine);
  void giveBack(sinumerik::Machine& machine, std::uint32_t word) const;
  void giveStack(std::vector<sinumerik::Frame>& frames) const;

  jit::Options options_;
  std::vector<std::unique_ptr<jit::NativeCode>> blocks_;
  std::unique_ptr<jit::NativeCode> nothing_;  // stands for a block without code of its own
  std::vector<Entry> entries_;                // small: what runs stays in the cache
  CallSites sites_;
  std::vector<Variant> variants_;
  std::size_t variantWords_ = 0;            // of the code that they were made of
  std::vector<std::uint32_t> variantOf_;    // by the word of the parameter list, from 1 on; 0: none
  std::vector<jit::OpenBlock> dataBlocks_;  // by number, as of the version of the block memory
  std::uint64_t dataVersion_ = ~std::uint64_t{0};
  Seat seat_;
  // Of the blocks in which the waiting calls go on: a jump may have led out of their own.
  std::array<std::uint32_t, sinumerik::kNesting> starts_{};
  std::uint64_t instructions_ = 0;
};

}  // namespace merker::cnc
