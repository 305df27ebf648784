#include <algorithm>

#include "case.h"
#include "mc7/listing.h"

namespace merker::differential {
namespace {

std::vector<std::uint8_t> without(const std::vector<std::uint8_t>& code, const mc7::Place& place,
                                  std::size_t end) {
  std::vector<std::uint8_t> out = code;  // NOP 0 keeps the distances
  std::fill(out.begin() + place.offset, out.begin() + static_cast<std::ptrdiff_t>(end), 0);
  return out;
}

}  // namespace

Case shrink(Case c, std::optional<icode::Opcode> broken) {
  for (auto block = c.blocks.begin(); block != c.blocks.end();) {
    Case smaller = c;
    smaller.blocks.erase(block->first);
    const BlockId id = block->first;
    ++block;
    if (!difference(smaller, broken).empty()) {
      c.blocks.erase(id);
    }
  }
  for (auto& [id, code] : c.blocks) {
    const mc7::Listing places = mc7::list(code);
    for (std::size_t i = 0; i < places.places.size(); ++i) {
      const std::size_t end =
          i + 1 < places.places.size() ? places.places[i + 1].offset : code.size();
      Case smaller = c;
      smaller.blocks[id] = without(code, places.places[i], end);
      if (!difference(smaller, broken).empty()) code = smaller.blocks[id];
    }
  }
  return c;
}

}  // namespace merker::differential
