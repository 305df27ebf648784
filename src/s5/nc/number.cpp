#include "nc/number.h"

#include <algorithm>
#include <array>

namespace merker::nc {
namespace {

constexpr std::array<std::int64_t, kMostPlaces + 1> kPowers{
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};

}  // namespace

std::int64_t scaled(std::int64_t digits, unsigned places, unsigned wanted) {
  return wanted >= places ? digits * kPowers.at(wanted - places)
                          : digits / kPowers.at(places - wanted);
}

std::optional<Number> makeNumber(std::int64_t digits, unsigned places) {
  if (digits > kMostDigits || digits < -kMostDigits || places > kMostPlaces) return std::nullopt;
  return Number{static_cast<std::int32_t>(digits), static_cast<std::uint8_t>(places)};
}

std::optional<Number> sum(Number a, Number b) {
  const unsigned places = std::max(a.places, b.places);
  return makeNumber(scaled(a, places) + scaled(b, places), places);
}

}  // namespace merker::nc
