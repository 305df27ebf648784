#include "profibus/bus_cycle.h"

namespace merker::profibus {

BusCycle busCycle(const io::DpMaster& master) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const auto time = [&](std::int64_t bits) {
    return Duration{(bits * kSecond + master.rate - 1) / master.rate};  // rounded up
  };
  BusCycle cycle;
  std::int64_t bits = kTokenBits;
  for (const io::Slave& slave : master.slaves) {
    cycle.begins.push_back(time(bits));
    bits += kTurnBits + kBitsPerByte * std::int64_t{slave.inputs + slave.outputs};
    cycle.ends.push_back(time(bits));
  }
  cycle.length = time(bits);
  return cycle;
}

}  // namespace merker::profibus
