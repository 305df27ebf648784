// Which rows of a table of bit patterns come into question, found without a look at all of them.
#pragma once

#include <bit>
#include <numeric>

#include "pattern/pattern.h"

namespace merker::pattern {

// What decides whether a row comes into question, small enough to look through quickly: a key of
// the code or of the operand, of which the bits of the mask count.
struct Entry {
  std::uint16_t row = 0, mask = 0, bits = 0;
  constexpr bool fits(std::uint16_t key) const { return (key & mask) == bits; }
};

// Rows in groups, in the order of the table within a group.
template <std::size_t Groups, std::size_t Entries>
struct Index {
  std::array<std::uint16_t, Groups + 1> start{};
  std::array<Entry, Entries> entries{};

  std::span<const Entry> group(std::size_t number) const {
    return std::span{entries}.subspan(start[number],
                                      static_cast<std::size_t>(start[number + 1] - start[number]));
  }
};

// The groups that a row is in: `bits` with every selection of the bits of `free`.
struct GroupSet {
  std::size_t bits = 0, free = 0;
  constexpr void forEach(auto&& visit) const {
    for (std::size_t some = free; some != 0; some = (some - 1) & free) visit(bits | some);
    visit(bits);
  }
};

// Decoding: groups are first bytes, the key is the first word.
struct ByFirstByte {
  static constexpr std::size_t kGroups = 256;
  static constexpr GroupSet groups(const auto& row) {
    return {row.bits >> 40, ~row.mask >> 40 & 0xFF};
  }
  static constexpr Entry entry(std::size_t number, const auto& row) {
    return {static_cast<std::uint16_t>(number), static_cast<std::uint16_t>(row.mask >> 32),
            static_cast<std::uint16_t>(row.bits >> 32)};
  }
};

template <const auto& Rows, typename Grouping>
constexpr std::size_t countEntries() {
  std::size_t count = 0;
  for (const auto& row : Rows) count += std::size_t{1} << std::popcount(Grouping::groups(row).free);
  return count;
}

template <const auto& Rows, typename Grouping>
constexpr auto makeIndex() {
  Index<Grouping::kGroups, countEntries<Rows, Grouping>()> index;
  for (const auto& row : Rows)
    Grouping::groups(row).forEach([&](std::size_t group) { ++index.start[group + 1]; });
  std::partial_sum(index.start.begin(), index.start.end(), index.start.begin());
  auto next = index.start;
  for (std::size_t i = 0; i < Rows.size(); ++i)
    Grouping::groups(Rows[i]).forEach(
        [&](std::size_t group) { index.entries[next[group]++] = Grouping::entry(i, Rows[i]); });
  return index;
}

// The instruction at the start of the code, by a table and its index ByFirstByte.
template <typename Decoded, typename Unit>
std::optional<Decoded> decode(std::span<const Unit> code, const auto& rows, const auto& index) {
  if (code.size_bytes() < 2) return std::nullopt;
  const std::uint64_t bits = fetch(code);
  const auto firstWord = static_cast<std::uint16_t>(bits >> 32);
  for (const Entry& entry : index.group(firstWord >> 8)) {
    if (!entry.fits(firstWord)) continue;
    const auto& row = rows[entry.row];
    if (row.length > code.size()) continue;
    if (const auto operand = pattern::decodeOperand(row, bits))
      return Decoded{{row.operation, *operand}, &row, row.length};
  }
  return std::nullopt;
}

}  // namespace merker::pattern
