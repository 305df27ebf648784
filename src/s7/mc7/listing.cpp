#include "mc7/listing.h"

#include "base/bytes.h"

namespace merker::mc7 {
namespace {

constexpr std::uint32_t kJump = 0x700B;

bool takesList(const Instruction& i) {
  const bool call = i.operation == Operation::UC || i.operation == Operation::CC;
  return call && i.operand.kind == OperandKind::Block &&
         (i.operand.blockKind == BlockKind::FC || i.operand.blockKind == BlockKind::SFC);
}

// Entries of the parameter list at `at` (MC7 section 7.2); 0 if there is none.
std::uint32_t listEntries(std::span<const std::uint8_t> code, std::size_t at) {
  if (at + 4 > code.size() || loadWord(&code[at]) != kJump) return 0;
  const std::uint32_t words = loadWord(&code[at + 2]);
  if (words < 4 || words % 2 != 0 || at + words * 2u > code.size()) return 0;
  return (words - 2) / 2;
}

}  // namespace

std::int32_t Listing::target(const Place& place) const {
  const std::int64_t words = static_cast<std::int32_t>(place.instruction.operand.value);
  const std::int64_t offset = place.offset + words * 2;
  const bool inside = offset >= 0 && offset / 2 < static_cast<std::int64_t>(placeAt.size());
  return inside ? placeAt[static_cast<std::size_t>(offset / 2)] : -1;
}

Listing list(std::span<const std::uint8_t> code) {
  Listing out;
  out.placeAt.resize(code.size() / 2 + 1, -1);
  std::size_t at = 0, skipUntil = 0;  // behind the JU over a parameter list
  while (at + 1 < code.size()) {
    out.placeAt[at / 2] = static_cast<std::int32_t>(out.places.size());
    Place& place = out.places.emplace_back();
    place.offset = static_cast<std::uint32_t>(at);
    const auto decoded = decode(code.subspan(at));
    at += decoded ? decoded->length : 2;
    if (!decoded) continue;
    place.known = true;
    place.instruction = decoded->instruction;
    if (skipUntil > at) {
      at = skipUntil;
      skipUntil = 0;
    }
    if (!takesList(place.instruction)) continue;
    const std::uint32_t entries = listEntries(code, at);
    place.firstParameter = static_cast<std::uint32_t>(out.parameters.size());
    place.parameters = static_cast<std::uint16_t>(entries);
    for (std::uint32_t i = 0; i < entries; ++i)
      out.parameters.push_back(loadDWord(&code[at + 4 + 4 * i]));
    skipUntil = entries == 0 ? 0 : at + 4 + 4 * entries;
  }
  if (out.placeAt.back() < 0 && code.size() % 2 == 0)
    out.placeAt.back() = static_cast<std::int32_t>(out.places.size());
  return out;
}

}  // namespace merker::mc7
