// The operand of an MC5 instruction, independent of its coding.
#pragma once

#include <cstdint>

namespace merker::mc5 {

enum class OperandKind : std::uint8_t {
  None,
  Memory,    // E, A, M, D, P: area and width; value = byte address, of D the word; bit
  Timer,     // T 5: value = number; width Bit: bit of the timer word (P T 5.3)
  Counter,   // Z 5
  Constant,  // format, value = bits
  Count,     // SLW 4, I 16, BLD 255, TNB 10, LIR 0: value
  Jump,      // value = signed distance in words from the jump itself (as two's complement)
  Block,     // SPA PB 5, A DB 10: block, value = number
  Formal     // U =EIN: value = index of the parameter, 1 = first (OP-05)
};

enum class Area : std::uint8_t { None, Input, Output, Flag, Data, Peripheral };

// Left and Right are the bytes of a data word: DL is the high one (S5-BLK-10).
enum class Width : std::uint8_t { Bit, Byte, Left, Right, Word, Double };

// The format tells the programmer's screen how to show a constant; the PLC ignores it (OP-46).
enum class Format : std::uint8_t {
  Byte,        // KB
  Hex,         // KH
  Counter,     // KZ
  Time,        // KT
  Fixed,       // KF
  Characters,  // KC
  Bytes,       // KY
  Binary,      // KM
  Float,       // KG
  SignedByte,  // BF of ADD
  Other        // a format byte that no programmer writes: in `bit`
};

enum class BlockType : std::uint8_t { Ob, Pb, Sb, Fb, Db };

struct Operand {
  OperandKind kind = OperandKind::None;
  Area area = Area::None;
  Width width = Width::Bit;
  Format format = Format::Hex;
  BlockType block = BlockType::Pb;
  std::uint8_t bit = 0;
  std::uint32_t value = 0;
  bool operator==(const Operand&) const = default;
};

}  // namespace merker::mc5
