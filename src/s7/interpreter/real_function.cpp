// SQRT SQR LN EXP SIN COS TAN ASIN ACOS ATAN (S7-INSTR-65 … -70): computed in double, then rounded
// once.
#include "interpreter/handlers.h"
#include "interpreter/real_number.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

double square(double x) { return x * x; }
double root(double x) { return x < 0 ? NAN : std::sqrt(x); }
// Of 0 too: no number (S7-INSTR-67).
double logarithm(double x) { return x > 0 ? std::log(x) : NAN; }
double exponential(double x) { return std::exp(x); }
double sine(double x) { return std::sin(x); }
double cosine(double x) { return std::cos(x); }
double tangent(double x) { return std::tan(x); }
double arcSine(double x) { return std::fabs(x) <= 1 ? std::asin(x) : NAN; }
double arcCosine(double x) { return std::fabs(x) <= 1 ? std::acos(x) : NAN; }
double arcTangent(double x) { return std::atan(x); }

// Beyond the range of REAL the conversion is the host's business; here it is infinity.
float rounded(double x) {
  constexpr double kLimit = 3.4028235677973366e+38;  // largest REAL and half a step
  if (std::fabs(x) >= kLimit) return x > 0 ? HUGE_VALF : -HUGE_VALF;
  return static_cast<float>(x);
}

template <double (*Function)(double)>
const Op* apply(cpu::Machine& m, const Op* op) {
  const double result = Function(real(m, 0));
  setReal(m, std::isnan(result) ? std::nanf("") : rounded(result));
  return op + 1;
}

}  // namespace

Rows realFunctionRows() {
  return {{Operation::SQRT, Form::None, apply<root>},
          {Operation::SQR, Form::None, apply<square>},
          {Operation::LN, Form::None, apply<logarithm>},
          {Operation::EXP, Form::None, apply<exponential>},
          {Operation::SIN, Form::None, apply<sine>},
          {Operation::COS, Form::None, apply<cosine>},
          {Operation::TAN, Form::None, apply<tangent>},
          {Operation::ASIN, Form::None, apply<arcSine>},
          {Operation::ACOS, Form::None, apply<arcCosine>},
          {Operation::ATAN, Form::None, apply<arcTangent>}};
}

}  // namespace merker::interpreter
