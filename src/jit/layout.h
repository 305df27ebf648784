// Where compiled code finds things in the machine, and which host register holds what.
#pragma once

#include <asmjit/x86.h>

#include <cstddef>

#include "cpu/machine.h"
#include "icode/region.h"

namespace merker::jit {

namespace host = asmjit::x86;

inline const host::Gp kMachine = host::rbx, kClock = host::r12, kCount = host::r13;
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

// The stack frame: values that found no register, then what the caller handed over. Enough for a
// bracket of 64 operands of which each needs three values.
constexpr int kSlots = 248;
constexpr int kTimers = 8 * kSlots, kCounters = kTimers + 8, kFrame = kCounters + 8;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
namespace offset {
constexpr int kClock = offsetof(cpu::Machine, clock);
constexpr int kHorizon = offsetof(cpu::Machine, horizon);
constexpr int kImage = offsetof(cpu::Machine, image);
constexpr int kTop = offsetof(cpu::Machine, top);
constexpr int kRelayOff = offsetof(cpu::Machine, mcrOff);
constexpr int kInstructions = offsetof(cpu::Machine, instructions);
constexpr int kBrackets = offsetof(cpu::Machine, brackets);
constexpr int kRegisters = offsetof(cpu::Machine, registers);
constexpr int kRelayActive = offsetof(cpu::Machine, mcrActive);
constexpr int kRelays = offsetof(cpu::Machine, mcrStack);
constexpr int kCallLimit = offsetof(cpu::Machine, callLimit);
constexpr int kFrames = offsetof(cpu::Machine, frames);
constexpr int kLevels = offsetof(cpu::Machine, levels);
constexpr int kFunctions = offsetof(cpu::Machine, functions);
constexpr int kFunctionBlocks = offsetof(cpu::Machine, functionBlocks);
constexpr int kDataBlocks = offsetof(cpu::Machine, dataBlocks);  // its only member is the vector
constexpr int kPosition = offsetof(cpu::Machine, position);
constexpr int kAr2 = kRegisters + offsetof(cpu::Registers, ar2);
constexpr int kDb = kRegisters + offsetof(cpu::Registers, db);
constexpr int kDi = kRegisters + offsetof(cpu::Registers, di);
constexpr int kStatus = kRegisters + offsetof(cpu::Registers, status);
// A vector: begin, end of what is in it, end of its memory.
constexpr int kEnd = 8, kCapacity = 16;
}  // namespace offset
static_assert(sizeof(cpu::DataBlocks) == sizeof(std::vector<cpu::DataBlock>));
static_assert(sizeof(cpu::OpenBlock) == 24 && sizeof(cpu::Bracket) == 4);

#pragma GCC diagnostic pop

}  // namespace merker::jit
