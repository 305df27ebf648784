// A pre-decoded instruction: what the loop runs. Blocks are translated once; nothing is looked up
// while they run.
#pragma once

#include <cstdint>

#include "cpu/machine.h"
#include "mc7/instruction.h"

namespace merker::interpreter {

struct Op;
// Does one instruction and returns the one to go on with.
using Handler = const Op* (*)(cpu::Machine&, const Op*);

struct Op {
  Handler run = nullptr;
  std::uint32_t cost = 0;  // ns
  std::uint32_t value =
      0;  // bit address, constant, number or index; form Image: byte in machine.image
  std::int32_t target =
      0;  // jump: distance in ops; call: first entry in the parameters of the block
  std::uint32_t offset = 0;  // of the instruction in the code, bytes
  std::uint16_t count = 0;   // call: entries; SPL: entries
  mc7::Operation operation = mc7::Operation::NOP0;
  mc7::OperandKind kind = mc7::OperandKind::None;
  Area area = Area::None;
  Area pointerArea = Area::None;
  Width width = Width::Bit;
  std::uint8_t reg = 0;
  std::uint8_t mask = 0;  // of the bit in its byte
  BlockKind blockKind = BlockKind::OB;
};

}  // namespace merker::interpreter
