// What becomes of instructions of STEP 5 in the intermediate code.
#include <gtest/gtest.h>

#include "lowering5/translate.h"
#include "mc5/disassembly.h"
#include "mc5/encoding.h"

namespace merker::translate5 {
namespace {

using Words = std::vector<std::uint16_t>;

// Of mc5/encodings.inc: NOP 0, L KB 1, BE; U E 0.0, U(, ) and a jump by three words.
constexpr std::uint16_t kNothing = 0x0000, kLoad = 0x2801, kEnd = 0x6500;
constexpr std::uint16_t kAnd = 0xC000, kOpen = 0xBA00, kClose = 0xBF00, kJump = 0x2D03;

std::vector<icode::Region> regionsOf(const Words& code) {
  auto regions = translate(code, Target{});
  for (const icode::Region& region : regions)
    EXPECT_EQ(icode::verify(region), "") << icode::print(region);
  return regions;
}

TEST(Region, StraightCodeIsOneRegionOf128Instructions) {
  Words code(100, kLoad);
  auto regions = regionsOf(code);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].instructions, 100u);
  code.assign(300, kLoad);
  regions = regionsOf(code);
  ASSERT_EQ(regions.size(), 3u);
  EXPECT_EQ(regions[0].instructions, 128u);
  EXPECT_EQ(regions[1].first, 128u);
  EXPECT_EQ(regions[2].instructions, 300u - 2 * 128u);
}

// Somebody who jumps there begins a region, too; behind a jump nothing of this region follows.
TEST(Region, BeginsWhereAJumpLeads) {
  const auto regions = regionsOf({kJump, kLoad, kLoad, kLoad, kLoad, kEnd});
  ASSERT_EQ(regions.size(), 3u);
  EXPECT_EQ(regions[0].instructions, 1u);
  EXPECT_EQ(regions[1].first, 1u);
  EXPECT_EQ(regions[1].instructions, 2u);
  EXPECT_EQ(regions[2].first, 3u);
  EXPECT_EQ(regions[2].instructions, 2u);
}

TEST(Region, BracketsAreInItFromEndToEnd) {
  const auto whole = regionsOf({kOpen, kAnd, kClose, kAnd, kEnd});
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].instructions, 4u);
  const auto open = regionsOf({kOpen, kAnd, kEnd});
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].first, 1u);
}

TEST(Region, LeavesOutWhatStaysWithTheProcessor) {
  const auto regions = translate(Words{kLoad, kLoad, kLoad}, Target{}, {false, true, false});
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].instructions, 1u);
  EXPECT_EQ(regions[1].first, 2u);
}

// ns of all instructions but the last.
TEST(Region, CountsTheTimeAhead) {
  const auto one = mc5::decode(Words{kLoad});
  const auto time =
      static_cast<std::uint64_t>(mc5::times(*one->encoding, Target{}.variant).longest.ns);
  const auto regions = regionsOf(Words(5, kLoad));
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].ahead, 4 * time);
}

// One operand that the row takes.
std::optional<Words> wordsOf(const mc5::Encoding& row) {
  for (const std::uint32_t value : {2u, 1u, 0u, 20u}) {
    mc5::Operand operand = row.operand;
    operand.value = value;
    Words code;
    if (mc5::encode(row, operand, code)) return code;
  }
  return std::nullopt;
}

std::string untranslated() {
  std::string left;
  for (const mc5::Encoding& row : mc5::encodings()) {
    const auto words = wordsOf(row);
    EXPECT_TRUE(words) << row.pattern;
    if (!words) continue;
    Words code = *words;
    code.insert(code.end(), 6, kNothing);
    const auto regions = regionsOf(code);
    if (regions.empty() || regions[0].first != 0)
      left += mc5::disassemble(*words).front().text + "; ";
  }
  return left;
}

TEST(Region, EveryRowHasATranslationBut) {
  // Brackets alone; the periphery; timers and counters in BCD, SA; floating
  // point; ways into other blocks without a site; ends; bits of timers and counters; conversions; B
  // in front of what it does not change; registers and areas of memory; formal operands without
  // their substitutes.
  EXPECT_EQ(untranslated(),
            "U(; O(; ); L     PB 2; L     PW 2; T     PB 2; T     PW 2; LC    Z 2; LC    T 2; "
            "SA    T 2; >G; <G; ><G; !=G; >=G; <=G; xG; :G; +G; -G; SPA   FB 2; SPA   PB 2; "
            "SPA   SB 2; A     DB 2; BE; BEA; STP; STS; RU    Z 2.0; SU    Z 2.0; RU    T 2.0; "
            "SU    T 2.0; DUF; DUD; DEF; DED; GFD; FDG; B     MW 2; B     DW 2; LIR   2; "
            "TIR   2; TNB   2; TNW   2; S     =2; RB    =2; =     =2; U     =2; O     =2; "
            "UN    =2; ON    =2; L     =2; T     =2; LC    =2; LW    =2; LD    =2; SI    =2; "
            "SE    =2; FR    =2; RD    =2; SVZ   =2; SSV   =2; SAR   =2; B     =2; ");
}

}  // namespace
}  // namespace merker::translate5
