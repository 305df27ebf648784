// SFC 36 MSK_FLT, 37 DMSK_FLT, 38 READ_ERR (S7-SFC-14): synchronous errors of the running priority
// class.
#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kAlready = 0x0001;  // part of it was masked (unmasked) before

cpu::ErrorMasks& masksOf(Arguments& a) { return a.machine().levels.back().masks; }

}  // namespace

void maskErrors(Arguments& a) {
  cpu::ErrorMasks& masks = masksOf(a);
  const std::uint32_t program = a.value(0), access = a.value(1);
  const bool already = (masks.programMask & program) != 0 || (masks.accessMask & access) != 0;
  masks.programMask |= program;
  masks.accessMask |= access;
  a.set(2, masks.programMask);
  a.set(3, masks.accessMask);
  a.status(already ? kAlready : 0);
}

void unmaskErrors(Arguments& a) {
  cpu::ErrorMasks& masks = masksOf(a);
  const std::uint32_t program = a.value(0), access = a.value(1);
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
  const std::uint32_t program = a.value(0), access = a.value(1);
  const bool unmasked = (~masks.programMask & program) != 0 || (~masks.accessMask & access) != 0;
  a.set(2, masks.programSeen & program);
  a.set(3, masks.accessSeen & access);
  masks.programSeen &= ~program;
  masks.accessSeen &= ~access;
  a.status(unmasked ? kAlready : 0);
}

}  // namespace merker::system
