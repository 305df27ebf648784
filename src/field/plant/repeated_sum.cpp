#include "plant/repeated_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace merker::plant {
namespace {

constexpr std::int64_t kFew = 16;  // are added one by one

// So many additions from here on surely add `next` - `sum`, which is exact: all results stay
// between the powers of two around `sum`, so they are rounded to the same place. Half a unit of
// this place would be rounded up or down by turns; such a summand has no even steps.
std::int64_t evenSteps(double sum, double summand, double next, std::int64_t count) {
  if (!std::isnormal(sum)) return 0;  // 0 has no exponent
  const int exponent = std::ilogb(sum);
  const double unit = std::ldexp(1, exponent - std::numeric_limits<double>::digits + 1);
  const double step = next - sum;
  if (std::abs(summand - step) == unit / 2) return 0;
  const bool grows = std::signbit(sum) == std::signbit(step);
  const double way = std::abs(std::ldexp(1, grows ? exponent + 1 : exponent) - std::abs(sum));
  const double steps = way / std::abs(step) - 1;
  return steps < static_cast<double>(count) ? static_cast<std::int64_t>(std::max(steps, 0.0))
                                            : count;
}

}  // namespace

double addRepeatedly(double sum, double summand, std::int64_t count) {
  while (count > 0) {
    const double next = sum + summand;
    if (next == sum) return sum;  // also where it is infinite
    const std::int64_t steps = count > kFew ? evenSteps(sum, summand, next, count) : 0;
    sum = steps > 1 ? sum + (next - sum) * static_cast<double>(steps) : next;
    count -= std::max<std::int64_t>(steps, 1);
  }
  return sum;
}

}  // namespace merker::plant
