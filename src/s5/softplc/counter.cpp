#include "softplc/counter.h"

#include "base/bcd.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint16_t kUpEdge = 0x2000, kDownEdge = 0x1000, kSetEdge = 0x0800,
                        kEnableEdge = 0x0400, kNotZero = 0xC000;
constexpr unsigned kHighest = 999;

}  // namespace

std::uint16_t Counter::coded() const { return static_cast<std::uint16_t>(toBcd(value(), 3)); }

void Counter::setValue(unsigned value) {
  word_ = static_cast<std::uint16_t>((word_ & ~(kNotZero | kValue)) | value |
                                     (value != 0 ? kNotZero : 0));
}

bool Counter::rises(std::uint16_t edge, bool vke) {
  const bool rising = vke && (word_ & edge) == 0;
  word_ = static_cast<std::uint16_t>(vke ? word_ | edge : word_ & ~edge);
  return rising;
}

bool Counter::set(bool vke, std::uint16_t akku) {
  if (!rises(kSetEdge, vke)) return false;
  const unsigned digits = (akku >> 8 & 0xF) * 100u + (akku >> 4 & 0xF) * 10u + (akku & 0xF);
  setValue(digits > kHighest ? kHighest : digits);
  return true;
}

bool Counter::up(bool vke) {
  if (!rises(kUpEdge, vke)) return false;
  if (value() < kHighest) setValue(value() + 1u);
  return true;
}

bool Counter::down(bool vke) {
  if (!rises(kDownEdge, vke)) return false;
  if (value() > 0) setValue(value() - 1u);
  return true;
}

bool Counter::reset(bool vke) {
  if (vke) setValue(0);
  return vke;
}

bool Counter::enable(bool vke) {
  if (!rises(kEnableEdge, vke)) return false;
  word_ &= static_cast<std::uint16_t>(~(kUpEdge | kDownEdge | kSetEdge));
  return true;
}

}  // namespace merker::sinumerik
