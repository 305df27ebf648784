// Frames for blocks that call each other, where the owner of the state lends none of its own
// (Layout::Blocks). Compiled code moves these; the owner fills them in before it runs and looks at
// them afterwards.
#pragma once

#include <array>
#include <cstdint>

namespace merker::jit {

// The open data block, or one that can be opened.
struct OpenBlock {
  void* data = nullptr;  // its bytes; null: there is none
  std::uint32_t readable = 0, writable = 0;
  std::array<std::uint32_t, 4> note{};  // what the owner wants to find again
};

// A call as it stands in the program.
struct Site {
  const void* target = nullptr;  // NativeCode::entrance of the block that is called
  std::uint32_t resume = 0;      // instruction of the caller behind the call
};

// A block that runs or waits for what it called.
struct Frame {
  OpenBlock open;              // as it was when the block called
  const Site* site = nullptr;  // by which the block was called, and
  const void* back = nullptr;  // where the caller goes on
};

}  // namespace merker::jit
