#include "signal/grid.h"

namespace merker::signal {
namespace {

__extension__ typedef __int128 Wide;

std::int64_t floorDivided(Wide a, std::int64_t b) {
  const Wide quotient = a / b;
  return static_cast<std::int64_t>(quotient - (a % b < 0 ? 1 : 0));
}

}  // namespace

Instant Grid::at(std::int64_t i, std::int64_t offset) const {
  const Wide distance = Wide{i} * period.numerator + offset;
  return start + Duration{floorDivided(distance, period.denominator)};
}

// Rounding down moves an instant by less than 1 ns, so the answer is one of two.
std::int64_t Grid::index(Instant t) const {
  const std::int64_t i = floorDivided(Wide{(t - start).ns} * period.denominator, period.numerator);
  return at(i + 1) <= t ? i + 1 : i;
}

}  // namespace merker::signal
