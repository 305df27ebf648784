// The logic operations on RLO, OR and /ER, each as the ledger writes it (S7-INSTR-02 … -07).
#pragma once

#include "cpu/status_word.h"

namespace merker::interpreter {

// VKE := ((VKE OR NOT /ER) AND op) OR (OR AND /ER); OR := OR AND /ER; STA := operand.
inline void andWith(cpu::StatusWord& s, bool term, bool state) {
  s.orBit = s.orBit && s.er;
  s.rlo = ((s.rlo || !s.er) && term) || s.orBit;
  s.sta = state;
  s.er = true;
}
inline void orWith(cpu::StatusWord& s, bool term, bool state) {
  s.rlo = (s.rlo && s.er) || term;
  s.sta = state;
  s.orBit = false;
  s.er = true;
}
inline void xorWith(cpu::StatusWord& s, bool term, bool state) {
  s.rlo = (s.rlo && s.er) != term;
  s.sta = state;
  s.orBit = false;
  s.er = true;
}

struct And {
  static void apply(cpu::StatusWord& s, bool bit) { andWith(s, bit, bit); }
};
struct AndNot {
  static void apply(cpu::StatusWord& s, bool bit) { andWith(s, !bit, bit); }
};
struct Or {
  static void apply(cpu::StatusWord& s, bool bit) { orWith(s, bit, bit); }
};
struct OrNot {
  static void apply(cpu::StatusWord& s, bool bit) { orWith(s, !bit, bit); }
};
struct Xor {
  static void apply(cpu::StatusWord& s, bool bit) { xorWith(s, bit, bit); }
};
struct XorNot {
  static void apply(cpu::StatusWord& s, bool bit) { xorWith(s, !bit, bit); }
};

}  // namespace merker::interpreter
