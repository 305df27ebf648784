// SFC 36 MSK_FLT, 37 DMSK_FLT, 38 READ_ERR (S7-SFC-14): synchronous errors of the running priority
// class.
#include "system/call.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kAlready = 0x0001;  // part of it was masked (unmasked) before

// Bit n of the program filter is event 16#252n, bit 16 + n is 16#253n; of the access filter bit n
// is 16#294n (S7-DIAG-02). Bits without an event mean nothing.
constexpr std::uint32_t kProgramErrors = 0xF43F03FE, kAccessErrors = 0x0000000C;

cpu::ErrorMasks& masksOf(Arguments& a) { return a.machine().levels.back().masks; }

}  // namespace

void maskErrors(Sfc<36>& a) {
  cpu::ErrorMasks& masks = masksOf(a);
  const std::uint32_t program = a.value("PRGFLT_SET_MASK") & kProgramErrors;
  const std::uint32_t access = a.value("ACCFLT_SET_MASK") & kAccessErrors;
  const bool already = (masks.programMask & program) != 0 || (masks.accessMask & access) != 0;
  masks.programMask |= program;
  masks.accessMask |= access;
  a.set("PRGFLT_MASKED", masks.programMask);
  a.set("ACCFLT_MASKED", masks.accessMask);
  a.status(already ? kAlready : 0);
}

void unmaskErrors(Sfc<37>& a) {
  cpu::ErrorMasks& masks = masksOf(a);
  const std::uint32_t program = a.value("PRGFLT_RESET_MASK") & kProgramErrors;
  const std::uint32_t access = a.value("ACCFLT_RESET_MASK") & kAccessErrors;
  const bool already = (~masks.programMask & program) != 0 || (~masks.accessMask & access) != 0;
  masks.programMask &= ~program;
  masks.accessMask &= ~access;
  masks.programSeen &= ~program;
  masks.accessSeen &= ~access;
  a.set("PRGFLT_MASKED", masks.programMask);
  a.set("ACCFLT_MASKED", masks.accessMask);
  a.status(already ? kAlready : 0);
}

// What has happened of the errors asked for; it is then forgotten.
void readErrors(Sfc<38>& a) {
  cpu::ErrorMasks& masks = masksOf(a);
  const std::uint32_t program = a.value("PRGFLT_QUERY") & kProgramErrors;
  const std::uint32_t access = a.value("ACCFLT_QUERY") & kAccessErrors;
  const bool unmasked = (~masks.programMask & program) != 0 || (~masks.accessMask & access) != 0;
  a.set("PRGFLT_CLR", masks.programSeen & program);
  a.set("ACCFLT_CLR", masks.accessSeen & access);
  masks.programSeen &= ~program;
  masks.accessSeen &= ~access;
  a.status(unmasked ? kAlready : 0);
}

}  // namespace merker::system
