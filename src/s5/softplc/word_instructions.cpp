// Digital logic and shifting (9.4.7, 9.4.8).
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::Instruction;
using mc5::Operation;

bool logic(Processor& p, unsigned result) {
  p.registers().setLow1(static_cast<std::uint16_t>(result));
  p.displays().setAnz(static_cast<std::uint16_t>(result) != 0, false);
  p.displays().ov = false;
  return true;
}

bool andW(Processor& p, const Instruction&) {
  return logic(p, p.registers().low2() & p.registers().low1());
}
bool orW(Processor& p, const Instruction&) {
  return logic(p, p.registers().low2() | p.registers().low1());
}
bool xorW(Processor& p, const Instruction&) {
  return logic(p, p.registers().low2() ^ p.registers().low1());
}

// ANZ 1 is the bit shifted out last (S5-SHIFT-02).
bool shifted(Processor& p, bool lastOut) {
  p.displays().setAnz(lastOut, false);
  p.displays().ov = false;
  return true;
}

bool shiftLeftW(Processor& p, const Instruction& i) {
  const unsigned n = i.operand.value, word = p.registers().low1();
  if (n == 0) return false;
  p.registers().setLow1(static_cast<std::uint16_t>(word << n));
  return shifted(p, (word >> (16 - n) & 1) != 0);
}

bool shiftRightW(Processor& p, const Instruction& i) {
  const unsigned n = i.operand.value, word = p.registers().low1();
  if (n == 0) return false;
  p.registers().setLow1(static_cast<std::uint16_t>(word >> n));
  return shifted(p, (word >> (n - 1) & 1) != 0);
}

bool shiftSignW(Processor& p, const Instruction& i) {
  const unsigned n = i.operand.value;
  const int word = static_cast<std::int16_t>(p.registers().low1());
  if (n == 0) return false;
  p.registers().setLow1(static_cast<std::uint16_t>(word >> n));
  return shifted(p, (word >> (n - 1) & 1) != 0);
}

bool shiftLeftD(Processor& p, const Instruction& i) {
  const unsigned n = i.operand.value;
  if (n == 0) return false;
  const std::uint64_t value = std::uint64_t{p.registers().akku1} << n;
  p.registers().akku1 = static_cast<std::uint32_t>(value);
  return shifted(p, (value >> 32 & 1) != 0);
}

bool shiftSignD(Processor& p, const Instruction& i) {
  const unsigned n = i.operand.value;
  if (n == 0) return false;
  const std::int64_t value = static_cast<std::int32_t>(p.registers().akku1);
  p.registers().akku1 = static_cast<std::uint32_t>(value >> n);
  return shifted(p, (value >> (n - 1) & 1) != 0);
}

constexpr HandlerRow kWordRows[] = {{Operation::AND_W, andW},
                                    {Operation::OR_W, orW},
                                    {Operation::XOR_W, xorW},
                                    {Operation::SHIFT_LEFT_W, shiftLeftW},
                                    {Operation::SHIFT_RIGHT_W, shiftRightW},
                                    {Operation::SHIFT_SIGN_W, shiftSignW},
                                    {Operation::SHIFT_LEFT_D, shiftLeftD},
                                    {Operation::SHIFT_SIGN_D, shiftSignD}};

}  // namespace

HandlerRows wordHandlers() { return kWordRows; }

}  // namespace merker::sinumerik
