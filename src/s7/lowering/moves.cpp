// L and T, accumulators and address registers (S7-INSTR-38 … -50, -85 … -91).
#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Value;
using mc7::OperandKind;
using mc7::Operation;

void push(Lowering& l, Value value) {
  l.to.set(Item::Accu2, l.to.get(Item::Accu1));
  l.to.set(Item::Accu1, value);
}

bool load(Lowering& l) {
  const mc7::Operand& o = l.operand();
  if (o.kind == OperandKind::Constant) {
    push(l, l.to.constant(o.value));
    return true;
  }
  if (o.kind == OperandKind::DataBlockInfo) {
    push(l, l.to.blockInfo(o.value));
    return true;
  }
  if (isCounter(o.kind) || isTimer(o.kind)) return loadTimerOrCounter(l);
  if (o.width == Width::Bit) return false;
  const auto value = readOperand(l, o.width);
  if (value) push(l, *value);
  return value.has_value();
}

bool transfer(Lowering& l) {
  const Width width = l.operand().width;
  if (width == Width::Bit || !writeOperand(l, width, l.to.get(Item::Accu1))) return false;
  l.needs.relayOn = true;
  return true;
}

// Bit by bit, /ER lowest.
constexpr Item kStatusWord[] = {Item::Er, Item::Rlo, Item::Sta, Item::Or, Item::Os,
                                Item::Ov, Item::Cc0, Item::Cc1, Item::Br};

// S7-INSTR-45: an S7-300 shows /ER, STA and OR as 0.
bool loadStatus(Lowering& l) {
  constexpr std::uint32_t kHidden = 0b0'0000'1101;
  icode::Builder& b = l.to;
  Value word = b.constant(0);
  for (std::uint32_t i = 0; i < std::size(kStatusWord); ++i) {
    if (l.model.accumulators != 4 && (kHidden >> i & 1) != 0) continue;
    const Value bit = b.make(Opcode::ToWord, b.get(kStatusWord[i]));
    word = b.make(Opcode::Or, word, b.withNumber(Opcode::Shl, bit, i));
  }
  push(l, word);
  return true;
}

bool transferStatus(Lowering& l) {
  icode::Builder& b = l.to;
  const Value accu = b.get(Item::Accu1);
  for (std::uint32_t i = 0; i < std::size(kStatusWord); ++i)
    b.set(kStatusWord[i], b.withNumber(Opcode::BitOf, accu, i));
  return true;
}

template <Item Register>
bool loadAddress(Lowering& l) {
  const mc7::Operand& o = l.operand();
  if (o.kind == OperandKind::None) {
    l.to.set(Register, l.to.get(Item::Accu1));
  } else if (o.kind == OperandKind::Constant || o.kind == OperandKind::Pointer) {
    l.to.set(Register, l.to.constant(o.value));
  } else if (o.kind == OperandKind::AddressRegister) {
    l.to.set(Register, l.to.get(Item::Ar2));
  } else {
    if (o.kind != OperandKind::Memory || o.width != Width::DWord) return false;
    const auto value = readOperand(l, Width::DWord);
    if (!value) return false;
    l.to.set(Register, *value);
  }
  return true;
}

template <Item Register>
bool storeAddress(Lowering& l) {
  const mc7::Operand& o = l.operand();
  if (o.kind == OperandKind::None) {
    push(l, l.to.get(Register));
    return true;
  }
  if (o.kind == OperandKind::AddressRegister) {
    l.to.set(Item::Ar2, l.to.get(Item::Ar1));
    return true;
  }
  return o.kind == OperandKind::Memory && o.width == Width::DWord &&
         writeOperand(l, Width::DWord, l.to.get(Register));
}

void exchangeItems(Lowering& l, Item x, Item y) {
  const Value before = l.to.get(x);
  l.to.set(x, l.to.get(y));
  l.to.set(y, before);
}

template <Item X, Item Y>
bool exchange(Lowering& l) {
  exchangeItems(l, X, Y);
  return true;
}

// Bits 23..0 only, the area stays.
template <Item Register>
bool advance(Lowering& l) {
  icode::Builder& b = l.to;
  const mc7::Operand& o = l.operand();
  const Value distance =
      o.kind == OperandKind::None
          ? b.make(Opcode::Sext16, b.get(Item::Accu1))
          : b.constant(static_cast<std::uint32_t>(static_cast<std::int16_t>(o.value)));
  const Value before = b.get(Register);
  const Value sum = b.make(Opcode::Add, before, distance);
  b.set(Register, b.make(Opcode::Or, b.make(Opcode::And, sum, b.constant(0x00FF'FFFF)),
                         b.make(Opcode::And, before, b.constant(0xFF00'0000))));
  return true;
}

bool swapLow(Lowering& l) {
  icode::Builder& b = l.to;
  const Value accu = b.get(Item::Accu1);
  const Value swapped = b.withNumber(Opcode::Shr, b.make(Opcode::SwapBytes, accu), 16);
  b.set(Item::Accu1, b.make(Opcode::LowFrom, accu, swapped));
  return true;
}

bool swapAll(Lowering& l) {
  l.to.set(Item::Accu1, l.to.make(Opcode::SwapBytes, l.to.get(Item::Accu1)));
  return true;
}

bool pushAccu(Lowering& l) {
  icode::Builder& b = l.to;
  if (l.model.accumulators == 4) {
    b.set(Item::Accu4, b.get(Item::Accu3));
    b.set(Item::Accu3, b.get(Item::Accu2));
  }
  b.set(Item::Accu2, b.get(Item::Accu1));
  return true;
}

bool popAccu(Lowering& l) {
  icode::Builder& b = l.to;
  b.set(Item::Accu1, b.get(Item::Accu2));
  if (l.model.accumulators == 4) {
    b.set(Item::Accu2, b.get(Item::Accu3));
    b.set(Item::Accu3, b.get(Item::Accu4));
  }
  return true;
}

bool enter(Lowering& l) {
  if (l.model.accumulators != 4) return false;
  l.to.set(Item::Accu4, l.to.get(Item::Accu3));
  l.to.set(Item::Accu3, l.to.get(Item::Accu2));
  return true;
}

bool leave(Lowering& l) {
  if (l.model.accumulators != 4) return false;
  l.to.set(Item::Accu2, l.to.get(Item::Accu3));
  l.to.set(Item::Accu3, l.to.get(Item::Accu4));
  return true;
}

template <Opcode Function>
bool step(Lowering& l) {
  icode::Builder& b = l.to;
  const Value accu = b.get(Item::Accu1);
  b.set(Item::Accu1,
        b.make(Opcode::ByteFrom, accu, b.make(Function, accu, b.constant(l.operand().value))));
  return true;
}

bool nothing(Lowering&) { return true; }

constexpr Row kMovesRows[] = {{Operation::LOAD, load},
                              {Operation::TRANSFER, transfer},
                              {Operation::LOAD_STW, loadStatus},
                              {Operation::TRANSFER_STW, transferStatus},
                              {Operation::LAR1, loadAddress<Item::Ar1>},
                              {Operation::LAR2, loadAddress<Item::Ar2>},
                              {Operation::TAR1, storeAddress<Item::Ar1>},
                              {Operation::TAR2, storeAddress<Item::Ar2>},
                              {Operation::TAR, exchange<Item::Ar1, Item::Ar2>},
                              {Operation::ADD_AR1, advance<Item::Ar1>},
                              {Operation::ADD_AR2, advance<Item::Ar2>},
                              {Operation::SWAP_BYTES_W, swapLow},
                              {Operation::SWAP_BYTES_D, swapAll},
                              {Operation::TAK, exchange<Item::Accu1, Item::Accu2>},
                              {Operation::PUSH, pushAccu},
                              {Operation::POP, popAccu},
                              {Operation::ENT, enter},
                              {Operation::LEAVE, leave},
                              {Operation::INC, step<Opcode::Add>},
                              {Operation::DEC, step<Opcode::Sub>},
                              {Operation::BLD, nothing},
                              {Operation::NOP0, nothing},
                              {Operation::NOP1, nothing}};

}  // namespace

std::span<const Row> moveRows() { return kMovesRows; }

}  // namespace merker::translate
