#include "cpu/s5_counter.h"

#include "base/bcd.h"

namespace merker::cpu {
namespace {

bool rising(bool rlo, bool& memory) {
  const bool edge = rlo && !memory;
  memory = rlo;
  return edge;
}

}  // namespace

// S7-CNT-08: stays at 999.
void S5Counter::up(bool rlo) {
  if (rising(rlo, upEdge) && count < 999) ++count;
}

// S7-CNT-09: stays at 0.
void S5Counter::down(bool rlo) {
  if (rising(rlo, downEdge) && count > 0) --count;
}

// S7-CNT-02, -03
bool S5Counter::set(bool rlo, std::uint16_t bcd) {
  if (!rising(rlo, setEdge)) return true;
  const auto value = fromBcd(bcd & 0xFFFu, 3);
  if (value) count = static_cast<std::uint16_t>(*value);
  return value.has_value();
}

// S7-CNT-04: as long as RLO is 1, no edge needed.
void S5Counter::reset(bool rlo) {
  if (rlo) count = 0;
}

// S7-CNT-13
void S5Counter::enable(bool rlo) {
  if (rising(rlo, enableEdge)) setEdge = upEdge = downEdge = false;
}

std::uint16_t S5Counter::bcd() const {
  return static_cast<std::uint16_t>(toBcd(std::uint32_t{count}, 3));
}

}  // namespace merker::cpu
