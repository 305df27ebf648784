// What the blocks of a PLC have in common, written once: the ways between the engine and compiled
// code, and those from block to block in frames of the owner.
#pragma once

#include <memory>

#include "jit/code_memory.h"
#include "jit/host.h"
#include "jit/layout.h"

namespace merker::jit {

struct Ways {
  Layout layout;  // for which it was written
  CodeMemory::Piece memory;
  const void* enter = nullptr;  // rdi: state, rsi: where to begin
  const void* leave = nullptr;  // rax: the answer
  // Of calls and returns (emit_frames.cpp); null: the layout has no frames.
  const void *enterBlock = nullptr, *enterWithout = nullptr, *leaveBlock = nullptr,
             *canCallFunction = nullptr, *canCallFunctionBlock = nullptr, *pushFrame = nullptr,
             *pushKept = nullptr;
};

// Those of this memory; written with the first block. Null: there was no room.
std::shared_ptr<const Ways> commonWays(const Layout& layout, CodeMemory& memory);

// Binds a label to each of the ways of calls and returns, and writes them.
struct BlockWays {
  asmjit::Label enterBlock, enterWithout, leaveBlock, canCallFunction, canCallFunctionBlock,
      pushFrame, pushKept;
};
BlockWays writeBlockWays(host::Assembler& code, const Layout& layout);

// ax: entries of the list of master control relays, of brackets.
void relayDepth(host::Assembler& code, const Layout::Frames& frames);
void bracketDepth(host::Assembler& code, const Layout::Frames& frames);

// Of a data block register; xmm0 and rcx are lost.
void copyBlock(host::Assembler& code, const host::Gp& to, int toAt, const host::Gp& from,
               int fromAt);
// Of both registers, which lie one behind the other.
void copyBlocks(host::Assembler& code, const host::Gp& to, int toAt, const host::Gp& from,
                int fromAt);

// Fixes the addresses of `code` and places it. Without data: there was no room.
CodeMemory::Piece placed(asmjit::CodeHolder& code, CodeMemory& memory);

}  // namespace merker::jit
