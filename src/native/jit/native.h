// Compiled code of one block.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "icode/region.h"
#include "jit/code_memory.h"
#include "jit/layout.h"

namespace merker::jit {

// What compiled code answers instead of a bare number: the address of instruction `n` in the list
// of whoever calls it.
struct Instructions {
  const void* first = nullptr;
  std::size_t stride = 0;
  const std::uint32_t* parameters = nullptr;  // of its calls, one list behind the other
};

struct Options {
  // For tests of the tests: the code of this operation gives a wrong result, or is missing if it
  // has none.
  std::optional<icode::Opcode> broken{};
  std::uint32_t slots = UINT32_MAX;  // and no more for values that find no register
  // All blocks of a PLC share it.
  std::shared_ptr<CodeMemory> memory = std::make_shared<CodeMemory>();
};

class NativeCode {
 public:
  NativeCode(std::shared_ptr<const Ways> ways, CodeMemory::Piece memory, std::size_t size,
             std::size_t entrance, std::vector<const void*> entries)
      : ways_(std::move(ways)),
        memory_(std::move(memory)),
        size_(size),
        entrance_(entrance),
        entries_(std::move(entries)) {}

  // Where other blocks enter, by instruction: a region, or the way back to the interpreter, which
  // stands behind the last instruction, too.
  const void* const* entries() const { return entries_.data(); }
  // Where calls enter it that come from a Site.
  const void* entrance() const { return at(entrance_); }
  // On a state of the layout that the code was compiled for, from an instruction that begins a
  // region on: returns in front of the instruction that is to be done next. That is the same one if
  // the horizon is too near or the region needs what is not there. Clock and count of instructions
  // are exact.
  const void* run(void* state, std::size_t instruction) const;
  // Bytes of machine code, without what all blocks have in common.
  std::size_t size() const { return size_; }

 private:
  const std::uint8_t* at(std::size_t offset) const {
    return static_cast<const std::uint8_t*>(memory_.data()) + offset;
  }
  std::shared_ptr<const Ways> ways_;
  CodeMemory::Piece memory_;
  std::size_t size_, entrance_;
  std::vector<const void*> entries_;
};

// Whether there is a compiler for this processor.
bool available();
// Regions must not have operations on what the layout does not name. With no instructions at all:
// the ways in and out of a block that has no compiled code. Null if there is no compiler, nothing
// to compile, or a region has too many values at a time.
std::unique_ptr<NativeCode> compile(std::span<const icode::Region> regions,
                                    std::size_t instructions, const Instructions& answers,
                                    const Layout& layout, const Options& options = {});

}  // namespace merker::jit
