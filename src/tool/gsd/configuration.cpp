#include "gsd/configuration.h"

#include <fmt/format.h>

namespace merker::gsd {
namespace {

constexpr std::uint8_t kInput = 0x10, kOutput = 0x20, kWords = 0x40, kConsistent = 0x80;

// General format: bits 0 to 3 length - 1, 4 input, 5 output, 6 words, 7 consistent over all.
DataArea compactArea(std::uint8_t id) {
  const std::uint32_t unit = (id & kWords) != 0 ? 2 : 1;
  const std::uint32_t length = ((id & 0x0Fu) + 1u) * unit;
  const bool whole = (id & kConsistent) != 0;
  DataArea area;
  if ((id & kInput) != 0) area.input = length, area.inputUnit = unit, area.consistentInput = whole;
  if ((id & kOutput) != 0)
    area.output = length, area.outputUnit = unit, area.consistentOutput = whole;
  return area;
}

struct Length {
  std::uint32_t bytes, unit;
  bool whole;
};

// Length byte of the special format: bits 0 to 5 length - 1, 6 words, 7 consistent over all.
Length readLength(std::uint8_t byte) {
  const std::uint32_t unit = (byte & kWords) != 0 ? 2 : 1;
  return {((byte & 0x3Fu) + 1u) * unit, unit, (byte & kConsistent) != 0};
}

std::uint32_t sumOf(const std::vector<DataArea>& areas, std::uint32_t DataArea::*length) {
  std::uint32_t sum = 0;
  for (const DataArea& area : areas) sum += area.*length;
  return sum;
}

}  // namespace

std::uint32_t Areas::input() const { return sumOf(areas, &DataArea::input); }
std::uint32_t Areas::output() const { return sumOf(areas, &DataArea::output); }

// Special format: bits 4 and 5 are 0, 6 an input length follows, 7 an output length (the output's
// first), 0 to 3 how many bytes of the maker follow; 15: none.
Areas readIdentifiers(std::span<const std::uint8_t> bytes) {
  Areas found;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::uint8_t id = bytes[i++];
    if ((id & (kInput | kOutput)) != 0) {
      found.areas.push_back(compactArea(id));
      continue;
    }
    const std::size_t own = (id & 0x0Fu) == 15 ? 0 : id & 0x0Fu;
    const std::size_t lengths = ((id & 0x40u) != 0 ? 1u : 0u) + ((id & 0x80u) != 0 ? 1u : 0u);
    if (bytes.size() - i < lengths + own) {
      found.wrong = fmt::format("behind 0x{:02X} there must be {} bytes, not {}", id, lengths + own,
                                bytes.size() - i);
      if (bytes.size() - i < lengths) return found;
    }
    DataArea area;
    if ((id & 0x80u) != 0) {
      const Length out = readLength(bytes[i++]);
      area.output = out.bytes, area.outputUnit = out.unit, area.consistentOutput = out.whole;
    }
    if ((id & 0x40u) != 0) {
      const Length in = readLength(bytes[i++]);
      area.input = in.bytes, area.inputUnit = in.unit, area.consistentInput = in.whole;
    }
    found.areas.push_back(area);
    i = std::min(i + own, bytes.size());
  }
  return found;
}

}  // namespace merker::gsd
