// Identifiers of the configuration telegram (EN 50170, Chk_Cfg): what a module has as inputs and
// outputs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace merker::gsd {

struct DataArea {
  std::uint32_t input = 0, output = 0;                     // bytes
  bool consistentInput = false, consistentOutput = false;  // over all bytes, else over its unit
  std::uint32_t inputUnit = 1, outputUnit = 1;             // bytes that stay together: 1 or 2
};

struct Areas {
  std::vector<DataArea> areas;  // one for each identifier, an empty slot too
  std::string wrong;            // what is wrong with the bytes; empty if nothing is
  std::uint32_t input() const;
  std::uint32_t output() const;
};

Areas readIdentifiers(std::span<const std::uint8_t> bytes);

}  // namespace merker::gsd
