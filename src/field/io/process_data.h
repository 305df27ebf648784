// Words of the telegram that a DP slave exchanges with its master, high byte first: what a drive
// behind the slave reads and answers.
#pragma once

#include <cstdint>

namespace merker::io {

struct ProcessData {
  std::uint32_t module = 0;  // index in Configuration::modules
  bool setpoint = false;     // from the master
  std::uint8_t word = 0;     // of the telegram, from 0
  std::uint8_t words = 1;    // 0: no word, but whether the master's data are good
  bool operator==(const ProcessData&) const = default;
};

}  // namespace merker::io
