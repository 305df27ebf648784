// The code blocks of a PLC as machine code of this computer: filled into the seam of `sinumerik`.
#pragma once

#include <memory>
#include <vector>

#include "cnc/block_links.h"
#include "jit/native.h"
#include "sinumerik/engine.h"

namespace merker::cnc {

struct CompilerOptions {
  jit::Options jit{};
  // Into a region of fewer instructions the way is longer than through the processor; other regions
  // still lead on into it.
  std::uint32_t shortestEntry = 3;
};

struct Seat;

class CompiledCode : public sinumerik::Engine {
 public:
  explicit CompiledCode(CompilerOptions options = {}) : options_(options) {}

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
    std::optional<Link> link{};
  };
  void linkBlock(const sinumerik::Machine& machine, const sinumerik::Entry& block,
                 const sinumerik::Environment& environment);
  void compileBlock(sinumerik::Machine& machine, const sinumerik::Entry& block,
                    const sinumerik::Environment& environment, const std::vector<bool>& apart);
  bool goOn(Seat& seat, sinumerik::Machine& machine) const;

  CompilerOptions options_;
  std::vector<std::unique_ptr<jit::NativeCode>> blocks_;
  std::vector<Entry> entries_;
  std::uint64_t instructions_ = 0;
};

}  // namespace merker::cnc
