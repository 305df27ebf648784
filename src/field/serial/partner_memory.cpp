#include "serial/partner_memory.h"

#include <algorithm>

namespace merker::serial {
namespace {

bool inBlocks(char type) { return type == 'D' || type == 'X'; }
bool countsWords(char type) { return type == 'T' || type == 'Z'; }

}  // namespace

// Areas always exist, data blocks from the first value on.
std::optional<std::size_t> PartnerMemory::size(char type, std::uint8_t block) const {
  if (inBlocks(type) && !areas_.contains(keyOf(type, block))) return std::nullopt;
  return inBlocks(type) ? kBlock : countsWords(type) ? kArea / 2 : kArea;
}

Bytes PartnerMemory::get(char type, std::uint8_t block, std::size_t offset,
                         std::size_t count) const {
  Bytes bytes(count);
  const auto found = areas_.find(keyOf(type, block));
  if (found == areas_.end()) return bytes;
  for (std::size_t i = 0; i < count && offset + i < found->second.size(); ++i)
    bytes[i] = found->second[offset + i];
  return bytes;
}

Bytes PartnerMemory::read(char type, std::uint8_t block, std::size_t offset,
                          std::size_t count) const {
  return get(type, block, countsWords(type) ? 2 * offset : offset, count);
}

bool PartnerMemory::set(char type, std::uint8_t block, std::size_t offset,
                        std::span<const std::uint8_t> data) {
  const std::size_t most = inBlocks(type) ? kBlock : kArea;
  if (offset > most || data.size() > most - offset) return false;
  Bytes& area = areas_[keyOf(type, block)];
  area.resize(most);
  std::copy(data.begin(), data.end(), area.begin() + static_cast<std::ptrdiff_t>(offset));
  return true;
}

void PartnerMemory::write(std::uint8_t block, std::size_t offset,
                          std::span<const std::uint8_t> data) {
  set('D', block, offset, data);
}

bool PartnerMemory::flag(const Flag& flag) const {
  return (get('M', 0, flag.byte, 1)[0] >> flag.bit & 1U) != 0;
}

void PartnerMemory::setFlag(const Flag& flag) {
  const Bytes byte{static_cast<std::uint8_t>(get('M', 0, flag.byte, 1)[0] | 1U << flag.bit)};
  set('M', 0, flag.byte, byte);
}

}  // namespace merker::serial
