// Virtual time: 64-bit nanoseconds since the station was switched on. Nothing here reads a wall
// clock.
#pragma once

#include <compare>
#include <cstdint>

namespace merker {

struct Duration {
  std::int64_t ns = 0;
  auto operator<=>(const Duration&) const = default;
  static constexpr Duration milliseconds(std::int64_t ms) { return {ms * 1'000'000}; }
  static constexpr Duration microseconds(std::int64_t us) { return {us * 1'000}; }
  static constexpr Duration seconds(std::int64_t s) { return {s * 1'000'000'000}; }
};

struct Instant {
  std::int64_t ns = 0;
  auto operator<=>(const Instant&) const = default;
  static constexpr Instant never() { return {INT64_MAX}; }
};

constexpr Instant operator+(Instant t, Duration d) { return {t.ns + d.ns}; }
constexpr Instant operator-(Instant t, Duration d) { return {t.ns - d.ns}; }
constexpr Duration operator-(Instant a, Instant b) { return {a.ns - b.ns}; }
constexpr Duration operator+(Duration a, Duration b) { return {a.ns + b.ns}; }
constexpr Duration operator-(Duration a, Duration b) { return {a.ns - b.ns}; }
constexpr Duration operator*(Duration d, std::int64_t n) { return {d.ns * n}; }

}  // namespace merker
