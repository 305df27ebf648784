#include "base/bcd.h"

#include <gtest/gtest.h>

#include "base/bytes.h"

namespace merker {
namespace {

static_assert(toBcd(0u) == 0 && toBcd(99u) == 0x99 && toBcd(107u) == 0x07);
static_assert(toBcd(314, 3) == 0x314 && toBcd(1314, 3) == 0x314);
static_assert(fromBcd(0x999, 3) == 999u && fromBcd(0x2200, 3) == 200u);
static_assert(!fromBcd(0x9A0, 3) && !fromBcd(0x00A, 3));

TEST(Bcd, allCountersThereAndBack) {
  for (std::uint32_t i = 0; i <= 999; ++i) EXPECT_EQ(fromBcd(toBcd(i, 3), 3), i);
}

// S7-ADDR-05: the byte at the lower address is the most significant.
TEST(Bytes, bigEndian) {
  std::uint8_t bytes[4] = {};
  storeDWord(bytes, 0x12345678);
  EXPECT_EQ(bytes[0], 0x12);
  EXPECT_EQ(bytes[3], 0x78);
  EXPECT_EQ(loadDWord(bytes), 0x12345678u);
  EXPECT_EQ(loadWord(bytes + 1), 0x3456);
  std::vector<std::uint8_t> list;
  appendDWord(list, 0x01020304);
  appendWord(list, 0x0506);
  EXPECT_EQ(list, (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace merker
