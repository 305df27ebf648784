// Which instructions ran, per source line, over all tests of a run; written as an lcov tracefile,
// which editors and CI servers show (docs/formats/scenario.md).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>

#include "station/station.h"

namespace merker::simulator {

class Coverage {
 public:
  // Adds what ran on the station since it was built (Options::coverage).
  void add(const station::Station& station);
  void write(std::ostream& out) const;

 private:
  void addBlock(const block::Block& block, const std::map<std::uint32_t, std::uint64_t>& counts);
  // File, line, how often it ran: the most executed instruction of the line counts.
  std::map<std::string, std::map<std::uint32_t, std::uint64_t>> lines_;
};

}  // namespace merker::simulator
