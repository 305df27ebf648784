#include "cpu/clock_memory.h"

namespace merker::cpu {
namespace {

// Half periods in ms, duty 1:1: 10, 5, 2.5, 2, 1.25, 1, 0.625, 0.5 Hz.
constexpr std::int64_t kHalfPeriods[] = {50, 100, 200, 250, 400, 500, 800, 1000};
constexpr std::int64_t kGrid = 50'000'000;  // ns, divides them all

}  // namespace

std::uint8_t clockMemory(Instant now) {
  unsigned bits = 0;
  for (unsigned bit = 0; bit < 8; ++bit)
    if (now.ns / (kHalfPeriods[bit] * 1'000'000) % 2 != 0) bits |= 1u << bit;
  return static_cast<std::uint8_t>(bits);
}

Instant nextClockMemory(Instant now) { return Instant{(now.ns / kGrid + 1) * kGrid}; }

ClockMemory::ClockMemory(std::optional<std::uint32_t> flag)
    : flag_(flag), next_(flag ? nextClockMemory(Instant{}) : Instant::never()) {}

void ClockMemory::update(Areas& areas, Instant now) {
  if (now < next_) return;
  next_ = nextClockMemory(now);
  if (*flag_ < areas.flagBytes) *areas.flag(*flag_) = clockMemory(now);
}

}  // namespace merker::cpu
