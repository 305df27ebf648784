// hrs/linkhrs.lnk: which block folder, symbol list and source folder a program has.
#pragma once

#include <cstdint>
#include <optional>

#include "archive/file.h"

namespace merker::s7p {

struct Links {
  std::optional<std::uint32_t> blocks, symbols, sources;
  // Type and number of the module that the program belongs to: a CPU in a station.
  std::optional<std::uint32_t> moduleType, module;
};

// The page of a program at `offset` (RSRVD4_L of its row); nothing if it is no page.
std::optional<Links> readLinks(const archive::File& file, std::uint32_t offset);

}  // namespace merker::s7p
