// Floating point arithmetic (9.3.8). Computed with the full mantissa, which S5-NUM-12 allows.
#include "mc5/s5_float.h"
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::FloatRange;
using mc5::Instruction;
using mc5::Operation;

double left(Processor& p) { return mc5::toDouble(p.registers().akku2); }
double right(Processor& p) { return mc5::toDouble(p.registers().akku1); }

// Sign of the mantissa; underflow shows as 0 with OV (S5-STAT-T1, OP-25).
bool put(Processor& p, double value) {
  const mc5::FloatResult result = mc5::fromDouble(value);
  p.registers().akku1 = result.bits;
  p.displays().overflow(result.range != FloatRange::Fits);
  const bool zero = result.range == FloatRange::Underflow;
  p.displays().setAnz(!zero && value > 0, !zero && value < 0);
  return true;
}

bool add(Processor& p, const Instruction&) { return put(p, left(p) + right(p)); }
bool subtract(Processor& p, const Instruction&) { return put(p, left(p) - right(p)); }
bool multiply(Processor& p, const Instruction&) { return put(p, left(p) * right(p)); }

bool divide(Processor& p, const Instruction&) {
  if (right(p) != 0) return put(p, left(p) / right(p));
  p.displays().overflow(true);
  p.displays().setAnz(true, true);
  return true;
}

constexpr HandlerRow kFloatRows[] = {{Operation::ADD_G, add},
                                     {Operation::SUB_G, subtract},
                                     {Operation::MUL_G, multiply},
                                     {Operation::DIV_G, divide}};

}  // namespace

HandlerRows floatHandlers() { return kFloatRows; }

}  // namespace merker::sinumerik
