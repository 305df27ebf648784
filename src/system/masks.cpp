// SFC 36 MSK_FLT, 37 DMSK_FLT, 38 READ_ERR (S7-SFC-14): synchronous errors of the running priority
// class.
#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kAlready = 0x0001;  // part of it was masked (unmasked) before

// Bit n of the program filter is event 16#252n, bit 16 + n is 16#253n; of the access filter bit n
// is 16#294n (S7-DIAG-02). Bits without an event mean nothing.
constexpr std::uint32_t kProgramErrors = 0xF43F03FE, kAccessErrors = 0x0000000C;

cpu::ErrorMasks& masksOf(Arguments& a) { return a.machine().levels.back().masks; }
std::uint32_t programBits(Arguments& a) { return a.value(0) & kProgramErrors; }
std::uint32_t accessBits(Arguments& a) { return a.value(1) & kAccessErrors; }

}  // namespace

void maskErrors(Arguments& a) {
  cpu::ErrorMasks& masks = masksOf(a);
  const std::uint32_t program = programBits(a), access = accessBits(a);
  const bool already = (masks.programMask & program) != 0 || (masks.accessMask & access) != 0;
  masks.programMask |= program;
  masks.accessMask |= access;
  a.set(2, masks.programMask);
  a.set(3, masks.accessMask);
  a.status(already ? kAlready : 0);
}

void unmaskErrors(Arguments& a) {
  cpu::ErrorMasks& masks = masksOf(a);
  const std::uint32_t program = programBits(a), access = accessBits(a);
  const bool already = (~masks.programMask & program) != 0 || (~masks.accessMask & access) != 0;
  masks.programMask &= ~program;
  masks.accessMask &= ~access;
  masks.programSeen &= ~program;
  masks.accessSeen &= ~access;
  a.set(2, masks.programMask);
  a.set(3, masks.accessMask);
  a.status(already ? kAlready : 0);
}

// What has happened of the errors asked for; it is then forgotten.
void readErrors(Arguments& a) {
  cpu::ErrorMasks& masks = masksOf(a);
  const std::uint32_t program = programBits(a), access = accessBits(a);
  const bool unmasked = (~masks.programMask & program) != 0 || (~masks.accessMask & access) != 0;
  a.set(2, masks.programSeen & program);
  a.set(3, masks.accessSeen & access);
  masks.programSeen &= ~program;
  masks.accessSeen &= ~access;
  a.status(unmasked ? kAlready : 0);
}

}  // namespace merker::system
