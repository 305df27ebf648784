// Properties of the whole table: rows do not overlap, and every code comes back from its operand.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "mc7/encoding.h"

namespace merker::mc7 {
namespace {

std::array<std::uint8_t, 6> bytesOf(std::uint64_t code) {
  std::array<std::uint8_t, 6> bytes{};
  for (unsigned i = 0; i < 6; ++i) bytes[i] = static_cast<std::uint8_t>(code >> (40 - 8 * i));
  return bytes;
}

std::uint64_t lengthMask(unsigned length) {
  return ~std::uint64_t{0} << (48 - 8 * length) & 0xFFFFFFFFFFFF;
}

const Encoding* onlyRow(std::uint64_t code, int& count) {
  const Encoding* found = nullptr;
  count = 0;
  for (const Encoding& row : encodings()) {
    if ((code & row.mask) != row.bits || !decodeOperand(row, code)) continue;
    found = &row;
    ++count;
  }
  return found;
}

// Decode, encode with the same row, encode freely and decode again. Returns what is wrong, "" if
// nothing.
std::string roundTrip(const Encoding& row, std::uint64_t code) {
  const auto bytes = bytesOf(code);
  const auto decoded = decode(bytes);
  if (!decoded) return "not decoded";
  if (decoded->encoding != &row) return "decoded by another row";
  std::vector<std::uint8_t> again, shortest;
  if (!encode(row, decoded->instruction.operand, again)) return "operand does not fit its own row";
  if (!std::equal(again.begin(), again.end(), bytes.begin())) return "other code";
  if (again.size() != decoded->length) return "other length";
  if (!encode(decoded->instruction, shortest) || shortest.size() > again.size())
    return "longer code";
  const auto free = decode(shortest);
  if (!free || free->instruction != decoded->instruction) return "other instruction";
  return {};
}

// Fixed bits lie in the first word alone, so its 65,536 values show every overlap.
TEST(Rows, FixedBitsLieInTheFirstWord) {
  for (const Encoding& row : encodings()) {
    EXPECT_EQ(row.mask & 0xFFFFFFFF, 0u) << row.pattern;
    EXPECT_EQ(row.length % 2, 0u) << row.pattern;
  }
}

TEST(Rows, EveryFirstWordBelongsToOneRowOrNone) {
  constexpr std::array<std::uint32_t, 3> kFollowing{0x00020000, 0x00000000, 0xFFFFFFFF};
  int illegal = 0;
  for (std::uint64_t word = 0; word <= 0xFFFF; ++word) {
    for (const std::uint32_t following : kFollowing) {
      const std::uint64_t code = word << 32 | following;
      int count = 0;
      const Encoding* row = onlyRow(code, count);
      ASSERT_LE(count, 1) << std::hex << word;
      const auto decoded = decode(bytesOf(code));
      ASSERT_EQ(decoded ? decoded->encoding : nullptr, row) << std::hex << word;
      if (row != nullptr) {
        ASSERT_EQ(roundTrip(*row, code), "") << std::hex << code;
      }
      illegal += row == nullptr ? 1 : 0;
    }
  }
  EXPECT_GT(illegal, 3 * 20000);  // the free codes of MC7 section 9 at least
}

constexpr std::array kSamples{0x0000u, 0x0001u, 0x0002u, 0x0007u, 0x0008u, 0x0010u,
                              0x00FFu, 0x0100u, 0x03E8u, 0x4000u, 0x7FFEu, 0x7FFFu,
                              0x8000u, 0xAAAAu, 0xFFFEu, 0xFFFFu};

// All values of the fields up to eight bits in every combination, chosen values of the wide ones.
int checkCombinations(const Encoding& row, unsigned field, std::uint64_t code) {
  if (field == row.fieldCount) {
    if (!decodeOperand(row, code)) return 0;
    EXPECT_EQ(roundTrip(row, code), "") << row.pattern << std::hex << " " << code;
    return 1;
  }
  const Field& f = row.fields[field];
  int checked = 0;
  if (f.bits <= 8) {
    for (std::uint64_t v = 0; v < std::uint64_t{1} << f.bits; ++v)
      checked += checkCombinations(row, field + 1, code | v << f.shift);
    return checked;
  }
  for (const std::uint64_t v : kSamples) {
    checked += checkCombinations(row, field + 1, code | v << f.shift);
    if (f.bits == 32)
      checked += checkCombinations(row, field + 1, code | (v << 16 | 0x1234) << f.shift);
  }
  return checked;
}

TEST(Rows, EncodeIsTheInverseOfDecodeForAllFieldValues) {
  for (const Encoding& row : encodings())
    EXPECT_GT(checkCombinations(row, 0, row.bits), 0) << row.pattern;
}

// Every value of the 16-bit fields, with M as the area; rows with the same field and kind of
// operand as an earlier one are tried with every 13th value.
TEST(Rows, EveryValueOfAWordFieldComesBack) {
  std::set<std::pair<char, OperandKind>> seen;
  for (const Encoding& row : encodings()) {
    if (row.fieldCount == 0) continue;
    const Field& wide = row.fields[row.fieldCount - 1];
    if (wide.bits != 16) continue;
    // Areas 3 (M) exist in every field of areas; bit, register 0 and so on exist everywhere.
    std::uint64_t code = row.bits;
    for (unsigned i = 0; i + 1 < row.fieldCount; ++i) {
      const char letter = row.fields[i].letter;
      if (letter == 'a' || letter == 'm' || letter == 'p')
        code |= std::uint64_t{3} << row.fields[i].shift;
    }
    const std::uint64_t step = seen.insert({wide.letter, row.operand.kind}).second ? 1 : 13;
    for (std::uint64_t v = 0; v <= 0xFFFF; v += step) {
      const std::uint64_t full = code | v << wide.shift;
      const auto operand = decodeOperand(row, full);
      const bool allowed = wide.letter != 'i' || (v >= 2 && v % 2 == 0);
      const bool good = operand ? encodeOperand(row, *operand) == full : !allowed;
      if (!good || operand.has_value() != allowed) {
        ADD_FAILURE() << row.pattern << " " << v;
        break;
      }
    }
  }
}

TEST(Rows, CodeThatIsCutOffIsNoInstruction) {
  for (const Encoding& row : encodings()) {
    std::uint64_t code = 0x000200000000 >> 16 | row.bits;
    for (unsigned i = 0; i < row.fieldCount; ++i) {
      const char letter = row.fields[i].letter;
      if (letter == 'a' || letter == 'm' || letter == 'p')
        code |= std::uint64_t{3} << row.fields[i].shift;
    }
    code &= lengthMask(row.length);
    const auto bytes = bytesOf(code);
    const std::span<const std::uint8_t> all{bytes};
    if (row.fieldCount > 0 && row.fields[0].letter == 'i') continue;
    const auto whole = decode(all.first(row.length));
    ASSERT_TRUE(whole) << row.pattern;
    EXPECT_EQ(whole->length, row.length);
    EXPECT_FALSE(decode(all.first(row.length - 1))) << row.pattern;
    EXPECT_FALSE(decode(all.first(0)));
  }
}

}  // namespace
}  // namespace merker::mc7
