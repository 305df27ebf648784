// The state that compiled STEP 5 works on, and where it lies in it.
#pragma once

#include <array>
#include <cstdint>

#include "jit/blocks.h"
#include "jit/layout.h"
#include "softplc/machine.h"

namespace merker::cnc {

// The registers of the running level, its blocks, and where the rest stands.
struct Seat {
  Instant clock, horizon;
  std::uint64_t instructions = 0;
  void* images = nullptr;
  std::uint32_t akku1 = 0, akku2 = 0, unused = 0;
  sinumerik::Displays displays;
  jit::OpenBlock open;  // of the running block
  void* cells = nullptr;
  jit::Frame *top = nullptr, *first = nullptr, *last = nullptr;
  const jit::Site* sites = nullptr;
  const jit::OpenBlock* dataBlocks = nullptr;
  std::array<jit::Frame, sinumerik::kNesting> frames;
  std::array<jit::Site, sinumerik::kNesting> found;  // by which they were called, as it was found
};

jit::Layout layoutOf(const sinumerik::Machine& m);
jit::OpenBlock openBlock(sinumerik::Machine& m, const sinumerik::OpenData& data);
sinumerik::OpenData openData(const jit::OpenBlock& open);
std::uint32_t bytesBetween(const void* from, const void* to);

}  // namespace merker::cnc
