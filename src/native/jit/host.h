// Which host register holds what, and the stack frame.
#pragma once

#include <asmjit/x86.h>

#include <cstddef>

#include "icode/region.h"

namespace merker::jit {

namespace host = asmjit::x86;

inline const host::Gp kState = host::rbx, kClock = host::r12, kCount = host::r13;
inline host::Mem inState(int at) { return host::qword_ptr(kState, at); }
// The images of inputs, outputs and flags: their byte kBias, so that 256 bytes of each are near.
inline const host::Gp kImages[] = {host::rbp, host::r14, host::r15};
constexpr int kBias = 128;
inline host::Mem inImage(icode::Space space, std::uint32_t byte, std::uint32_t bytes) {
  return {kImages[static_cast<std::size_t>(space)], static_cast<int>(byte) - kBias, bytes};
}
// Values live in these, those that are needed for long in the last ones, whose codes are longer;
// rax, rcx and rdx are free for every emitter.
inline const host::Gp kPlaces[] = {host::rsi, host::rdi, host::r8, host::r9, host::r10, host::r11};
constexpr unsigned kPlaceCount = 6;

// The stack frame: values that found no register. Enough for a bracket of 64 operands of which each
// needs three values.
constexpr int kSlots = 248, kFrame = 8 * kSlots;

}  // namespace merker::jit
