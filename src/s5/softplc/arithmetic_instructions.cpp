// Fixed point arithmetic, ADD, I, D (9.3.8, 9.4.10, 9.4.14).
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::Instruction;
using mc5::Operation;

std::int32_t left(Processor& p) { return static_cast<std::int16_t>(p.registers().low2()); }
std::int32_t right(Processor& p) { return static_cast<std::int16_t>(p.registers().low1()); }

bool fits(std::int32_t value) { return value >= -32768 && value <= 32767; }

// Akku 1-H is the sign of a result that fits, 0 after an overflow (S5-ARITH-03, OP-35).
void put(Processor& p, std::int32_t value) {
  const auto word = static_cast<std::uint16_t>(value);
  p.registers().akku1 = fits(value) ? static_cast<std::uint32_t>(value) : word;
  p.displays().overflow(!fits(value));
}

// ANZ of a sum is the sign of the 16 bits that remain: "over-zero" shows as 0 (S5-STAT-07).
bool sum(Processor& p, std::int32_t value) {
  put(p, value);
  const auto rest = static_cast<std::int16_t>(value);
  p.displays().setAnz(rest > 0, rest < 0);
  return true;
}

// A product that does not fit: 0 1 beyond the positive, 1 0 beyond the negative end (S5-STAT-T1).
bool product(Processor& p, std::int32_t value) {
  put(p, value);
  const bool over = !fits(value);
  p.displays().setAnz(over ? value < 0 : value > 0, over ? value > 0 : value < 0);
  return true;
}

bool add(Processor& p, const Instruction&) { return sum(p, left(p) + right(p)); }
bool subtract(Processor& p, const Instruction&) { return sum(p, left(p) - right(p)); }
bool multiply(Processor& p, const Instruction&) { return product(p, left(p) * right(p)); }

// Quotient in Akku 1-L, remainder in Akku 1-H (S5-ARITH-04).
bool divide(Processor& p, const Instruction&) {
  const std::int32_t a = left(p), b = right(p);
  if (b == 0) {
    p.displays().overflow(true);
    p.displays().setAnz(true, true);
    return true;
  }
  if (!fits(a / b)) return product(p, a / b);
  product(p, a / b);
  p.registers().akku1 = static_cast<std::uint32_t>(static_cast<std::uint16_t>(a % b)) << 16 |
                        static_cast<std::uint16_t>(a / b);
  return true;
}

bool addConstant(Processor& p, const Instruction& i) {
  const bool byte = i.operand.format == mc5::Format::SignedByte;
  const int value =
      byte ? static_cast<std::int8_t>(i.operand.value) : static_cast<std::int16_t>(i.operand.value);
  p.registers().setLow1(static_cast<std::uint16_t>(p.registers().low1() + value));
  return true;
}

// Only the low byte, without carry (S5-INCDEC-01).
template <int Sign>
bool count(Processor& p, const Instruction& i) {
  std::uint32_t& akku = p.registers().akku1;
  akku = (akku & 0xFFFFFF00) | ((akku + Sign * static_cast<int>(i.operand.value)) & 0xFF);
  return true;
}

constexpr HandlerRow kArithmeticRows[] = {{Operation::ADD_F, add},
                                          {Operation::SUB_F, subtract},
                                          {Operation::MUL_F, multiply},
                                          {Operation::DIV_F, divide},
                                          {Operation::ADD_BYTE, addConstant},
                                          {Operation::ADD_WORD, addConstant},
                                          {Operation::INCREMENT, count<1>},
                                          {Operation::DECREMENT, count<-1>}};

}  // namespace

HandlerRows arithmeticHandlers() { return kArithmeticRows; }

}  // namespace merker::sinumerik
