// What the CPU remembers about running blocks: one frame per block (B stack), one level per
// priority class or synchronous error OB (I stack).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "block/block.h"
#include "cpu/outlook.h"
#include "cpu/registers.h"

namespace merker::cpu {

// What an engine made of a block. Each engine derives its own form; the CPU only keeps it.
struct Code {
  const block::Block* source = nullptr;
  std::uint32_t localBytes = 0;  // even
  // Compiled code: where the host goes on for each instruction; null while there is none.
  const void* const* native = nullptr;
  // What compiled code of a caller looks for that has this block's instructions in itself; null:
  // the block must be called.
  const void* mark = nullptr;
  // Instructions that look at a running timer's time, or in OB 1 at its date, wherever they are
  // executed.
  std::vector<Look> looks;
  virtual ~Code() = default;
};

// Bracket stack entry (S7-INSTR-08).
struct Bracket {
  std::uint8_t function = 0;  // the opening operation, in the engine's count
  bool rlo = false, orBit = false, er = false;
};

struct Frame {
  const Code* code = nullptr;
  std::uint32_t resume = 0;  // where the block goes on, in the engine's count
  bool first = false;        // bottom of a level: its end is the end of an OB
  std::uint8_t* local = nullptr;
  std::uint32_t localLength = 0;
  std::uint32_t localEnd = 0;  // of the level's local data stack
  // Parameter list behind the call (MC7 section 7.2): pointers as they stand in the code.
  const std::uint32_t* parameters = nullptr;
  std::uint32_t parameterCount = 0;
  // What BE gives back to the caller (S7-INSTR-108).
  OpenBlock db{}, di{};
  std::uint32_t ar2 = 0;
  bool mcrActive = false;
  std::uint16_t mcrDepth = 0, bracketDepth = 0;
};

// Masks and reports of SFC 36..38, per priority class.
struct ErrorMasks {
  std::uint32_t programMask = 0, accessMask = 0;
  std::uint32_t programSeen = 0, accessSeen = 0;
};

struct Level {
  std::uint8_t ob = 0;
  std::uint8_t priority = 0;
  bool errorOb = false;          // OB 121, OB 122: continues the class of the block that caused it
  std::uint32_t frames = 0;      // blocks on this level
  std::uint32_t localBase = 0;   // error OB: local data below belong to the interrupted blocks
  std::uint32_t localStack = 0;  // which local data stack
  std::uint16_t bracketBase = 0, mcrBase = 0;
  bool mcrActive = false;   // of the interrupted block
  Registers interrupted{};  // given back at the end
  ErrorMasks masks{};
  std::int64_t wait = 0;                 // ns that SFC 47 still lets pass
  std::uint32_t delayed = 0;             // SFC 41 without SFC 42
  std::array<std::uint8_t, 20> start{};  // start information as it was handed over
};

}  // namespace merker::cpu
