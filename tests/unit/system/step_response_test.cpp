// CONT_C on a first-order process: the block in the CPU against the difference equation of PI
// controller and process, in double precision (PID-EX-01, PID-SIM-03).
#include <gtest/gtest.h>

#include <cmath>

#include "loop.h"

namespace merker::station::test {
namespace {

constexpr double kGain = 2, kPlantGain = 2, kTime = 20, kSetpoint = 50;

// e = GAIN (SP - PV): y_k = y_(k-1) + e_k - e_(k-1) + (e_k + e_(k-1)) CYCLE / (2 TI), the increment
// form, which the block does not use. The integral rests while the output is at its limit.
class PiController {
 public:
  double operator()(double pv) {
    const double e = kGain * (kSetpoint - pv);
    double step = (e + old_) / 2 / kTime;
    if (step > 0 && limited_) step = 0;
    integral_ += step;
    old_ = e;
    const double sum = e + integral_;
    limited_ = sum >= 100;
    return limited_ ? 100 : sum;
  }

 private:
  double old_ = 0, integral_ = 0;
  bool limited_ = false;
};

class Process {
 public:
  double value = 0;
  void step(double u) { value += (1 - std::exp(-1 / kTime)) * (kPlantGain * u - value); }
};

Loop controller() {
  Loop loop(41);
  loop.set("MAN_ON", false);
  loop.set("SP_INT", kSetpoint);
  return loop;
}

// To 1e-6 of the range. Each controller has a process of its own, so errors would grow.
TEST(StepResponse, agreesWithTheDifferenceEquation) {
  Loop loop = controller();
  PiController reference;
  Process process, referenceProcess;
  for (int k = 0; k <= 600; ++k) {
    const auto pv = static_cast<float>(process.value);
    loop.set("PV_IN", pv);
    loop.call();
    const double expected = reference(referenceProcess.value);
    ASSERT_NEAR(loop.real("LMN"), expected, 1e-6 * 100) << k;  // of the range 0 to 100 %
    ASSERT_NEAR(process.value, referenceProcess.value, 1e-6 * 100) << k;
    process.step(loop.real("LMN"));
    referenceProcess.step(expected);
  }
}

// PID-EX-01
TEST(StepResponse, hasTheValuesOfTheExample) {
  const struct {
    int t;
    double pv, lmn;
  } kRows[] = {{0, 0, 100},         {1, 9.754, 82.992},   {2, 17.374, 71.397},
               {5, 32.354, 48.76},  {10, 43.171, 32.788}, {20, 48.366, 25.837},
               {40, 49.592, 25.01}, {60, 49.852, 25.0},   {120, 49.993, 25.0}};
  Loop loop = controller();
  Process process;
  const auto* row = std::begin(kRows);
  for (int k = 0; row != std::end(kRows); ++k) {
    loop.set("PV_IN", process.value);
    loop.call();
    if (k == row->t) {
      EXPECT_NEAR(loop.real("PV"), row->pv, 0.01) << k;
      EXPECT_NEAR(loop.real("LMN"), row->lmn, 0.01) << k;
      ++row;
    }
    process.step(loop.real("LMN"));
  }
}

}  // namespace
}  // namespace merker::station::test
