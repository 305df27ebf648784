// Binary logic, memory operations, bit test (9.3.1, 9.3.2, 9.4.5).
#include "softplc/handlers.h"
#include "softplc/operand_access.h"

namespace merker::sinumerik {
namespace {

using mc5::Instruction;
using mc5::Operand;
using mc5::OperandKind;
using mc5::Operation;

// Bits of timer and counter words (P T 5.3) or their outputs (U T 5).
bool cellBit(std::uint16_t word, bool output, const Operand& operand) {
  return operand.width == mc5::Width::Bit ? (word >> operand.bit & 1) != 0 : output;
}

bool scan(Machine& m, const Operand& operand) {
  if (operand.kind == OperandKind::Timer) {
    const Timer& timer = m.timers[operand.value];
    return cellBit(timer.word(), timer.output(), operand);
  }
  if (operand.kind == OperandKind::Counter) {
    const Counter& counter = m.counters[operand.value];
    return cellBit(counter.word(), counter.output(), operand);
  }
  return read(m, operand) != 0;
}

// U, UN, with AND before OR (S5-BIT-02, S5-STAT-04).
template <bool Inverted>
bool andWith(Processor& p, const Instruction& i) {
  Displays& d = p.displays();
  const bool signal = scan(p.machine(), i.operand);
  const bool x = signal != Inverted;
  d.vke = ((d.vke || !d.chain) && x) || (d.orBit && d.chain);
  d.orBit = d.orBit && d.chain;
  d.status = signal;
  d.chain = true;
  return true;
}

template <bool Inverted>
bool orWith(Processor& p, const Instruction& i) {
  Displays& d = p.displays();
  const bool signal = scan(p.machine(), i.operand);
  d.vke = (d.vke && d.chain) || signal != Inverted;
  d.orBit = false;
  d.status = signal;
  d.chain = true;
  return true;
}

// O without operand: what stands before is one branch of the OR (S5-BIT-07).
bool andBeforeOr(Processor& p, const Instruction&) {
  Displays& d = p.displays();
  d.orBit = (d.vke || d.orBit) && d.chain;
  d.chain = d.vke && d.chain;
  d.status = true;
  return true;
}

// The manual gives no limit of nesting; this one only bounds the memory of an endless loop.
constexpr std::size_t kBrackets = 64;

template <bool IsOr>
bool open(Processor& p, const Instruction&) {
  Displays& d = p.displays();
  if (p.registers().brackets.size() >= kBrackets)
    return p.fail(Alarm::IllegalParameter, p.opcode());
  const bool before = d.chain ? d.vke : !IsOr;
  p.registers().brackets.push_back({before, d.orBit && d.chain, IsOr});
  d.orBit = d.chain = false;
  d.status = true;
  return true;
}

bool close(Processor& p, const Instruction&) {
  auto& brackets = p.registers().brackets;
  if (brackets.empty()) return p.fail(Alarm::IllegalCode, p.opcode());
  const Bracket bracket = brackets.back();
  brackets.pop_back();
  Displays& d = p.displays();
  d.vke = bracket.isOr ? bracket.vke || d.vke : (bracket.vke && d.vke) || bracket.orBit;
  d.orBit = bracket.orBit;
  d.status = d.chain = true;
  return true;
}

bool store(Processor& p, const Operand& operand, bool value) {
  if (write(p.machine(), operand, value ? 1 : 0)) return true;
  return p.fail(Alarm::TransferToMissingDb, p.opcode());
}

void endChain(Displays& d) {
  d.orBit = false;
  d.chain = false;
}

bool assign(Processor& p, const Instruction& i) {
  const bool value = p.vke();
  if (!store(p, i.operand, value)) return false;
  p.displays().status = value;
  endChain(p.displays());
  return true;
}

template <bool Value>
bool setIf(Processor& p, const Instruction& i) {
  const bool vke = p.vke();
  if (vke && !store(p, i.operand, Value)) return false;
  p.displays().status = scan(p.machine(), i.operand);
  endChain(p.displays());
  return vke;
}

// S Z, R T, R Z share their operations with the bits.
bool setBit(Processor& p, const Instruction& i) {
  if (i.operand.kind != OperandKind::Counter) return setIf<true>(p, i);
  const bool done = p.machine().counters[i.operand.value].set(p.vke(), p.registers().low1());
  endChain(p.displays());
  return done;
}

bool resetBit(Processor& p, const Instruction& i) {
  Machine& m = p.machine();
  bool done = false;
  if (i.operand.kind == OperandKind::Timer)
    done = m.timers[i.operand.value].reset(p.vke());
  else if (i.operand.kind == OperandKind::Counter)
    done = m.counters[i.operand.value].reset(p.vke());
  else
    return setIf<false>(p, i);
  endChain(p.displays());
  return done;
}

// P and PN begin a chain whatever stood before (S5-BITTEST-02).
template <bool Inverted>
bool test(Processor& p, const Instruction& i) {
  Displays& d = p.displays();
  d.status = scan(p.machine(), i.operand);
  d.vke = d.status != Inverted;
  d.orBit = false;
  d.chain = true;
  return true;
}

std::uint16_t withBit(std::uint16_t word, unsigned bit, bool value) {
  return static_cast<std::uint16_t>(value ? word | 1u << bit : word & ~(1u << bit));
}

template <bool Value>
bool force(Processor& p, const Instruction& i) {
  Machine& m = p.machine();
  const Operand& operand = i.operand;
  if (operand.kind == OperandKind::Timer) {
    Timer& timer = m.timers[operand.value];
    timer.setWord(withBit(timer.word(), operand.bit, Value));
  } else if (operand.kind == OperandKind::Counter) {
    Counter& counter = m.counters[operand.value];
    counter.setWord(withBit(counter.word(), operand.bit, Value));
  } else {
    return store(p, operand, Value);
  }
  return true;
}

constexpr HandlerRow kBitRows[] = {{Operation::AND, andWith<false>},
                                   {Operation::AND_NOT, andWith<true>},
                                   {Operation::OR, orWith<false>},
                                   {Operation::OR_NOT, orWith<true>},
                                   {Operation::AND_BEFORE_OR, andBeforeOr},
                                   {Operation::AND_OPEN, open<false>},
                                   {Operation::OR_OPEN, open<true>},
                                   {Operation::CLOSE, close},
                                   {Operation::ASSIGN, assign},
                                   {Operation::SET_BIT, setBit},
                                   {Operation::RESET_BIT, resetBit},
                                   {Operation::TEST_BIT, test<false>},
                                   {Operation::TEST_NOT, test<true>},
                                   {Operation::SET_ALWAYS, force<true>},
                                   {Operation::RESET_ALWAYS, force<false>}};

}  // namespace

HandlerRows bitHandlers() { return kBitRows; }

}  // namespace merker::sinumerik
