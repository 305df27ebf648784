// The code blocks of a PLC as machine code of this computer: filled into the seam of `sinumerik`.
#pragma once

#include <memory>
#include <vector>

#include "cnc/block_links.h"
#include "jit/native.h"
#include "sinumerik/engine.h"
#include "translate5/translate.h"

namespace merker::cnc {

struct Seat;

class CompiledCode : public sinumerik::Engine {
 public:
  explicit CompiledCode(jit::Options options = {}) : options_(options) {}

  void compile(sinumerik::Machine& machine, const sinumerik::Environment& environment,
               const std::vector<bool>& apart) override;
  std::uint64_t run(sinumerik::Machine& machine, Instant horizon) override;
  // What ran compiled so far.
  std::uint64_t instructions() const { return instructions_; }

 private:
  // A word of segment 5 where a region begins, or a way into another block, or both.
  struct Entry {
    const jit::NativeCode* code = nullptr;
    std::uint32_t start = 0;  // of the block
    std::uint32_t link = 0;   // from 1 on; 0: none
  };
  // A function block for one of its calls.
  struct Variant {
    std::uint32_t start = 0;  // of the block
    std::vector<Entry> entries;
  };
  void compileBlock(sinumerik::Machine& machine, const sinumerik::Entry& block,
                    const sinumerik::Environment& environment, const std::vector<bool>& apart,
                    const translate5::Substitutes& substitutes, std::span<Entry> entries);
  void compileCalls(sinumerik::Machine& machine, const sinumerik::Entry& block,
                    const sinumerik::Environment& environment, const std::vector<bool>& apart);
  void compileCall(sinumerik::Machine& machine, mc5::BlockId block, std::uint32_t parameters,
                   const sinumerik::Environment& environment, const std::vector<bool>& apart);
  const Entry& entryAt(const sinumerik::Frame& frame) const;
  bool goOn(Seat& seat, sinumerik::Machine& machine) const;

  jit::Options options_;
  std::vector<std::unique_ptr<jit::NativeCode>> blocks_;
  std::vector<Entry> entries_;  // small: what runs stays in the cache
  std::vector<Link> links_;
  std::vector<Variant> variants_;
  std::vector<std::uint32_t> variantOf_;  // by the word of the parameter list, from 1 on; 0: none
  std::uint64_t instructions_ = 0;
};

}  // namespace merker::cnc
