#include "listing.h"
#include "monitor/block_list.h"
#include "monitor/location.h"

namespace merker::monitor::test {
namespace {

const char* const kBlocks =
    "OB 1\n"
    " : U   E 0.0\n"
    " : SPA FB 5\n"  // 3
    "NAME : VENTIL\n"
    "EIN : E 1.0\n"
    " : SPA PB 5\n"  // 6
    " : BE\n"
    "PB 5\n"
    " : L   KH 0001\n"  // 9
    " : T   MW 10\n"
    " : ***\n"
    "NETZWERK 2\n"
    " : U   M 0.0\n"  // 13
    " : BE\n"
    "FB 5\n"
    "NAME : VENTIL\n"
    "BEZ : EIN  E/A/D/B/T/Z: E  BI/BY/W/D: BI\n"
    " : U   =EIN\n"  // 18
    " : BE\n"
    "DB 10\n"
    "   0 : KH = 0000\n";  // 21

struct Step5Places : ::testing::Test {
  mc5::Program program = listing(kBlocks);
  source::SymbolTable symbols;
  LocationContext here{program, symbols, "press.s5"};
  std::string find(const std::string& text) {
    const auto place = findLocation(text, here);
    return place ? toString(*place) : std::string(place.error().name());
  }
  const mc5::Block& block(mc5::BlockType type, std::uint16_t number) {
    return program.at({type, number});
  }
};

// S5-BLK-10: places of STEP 5 count words.
TEST_F(Step5Places, AreWrittenAsThoseOfTheS7) {
  for (const char* text :
       {"PB 5:13", "pb5:13", "press.s5:13", "13", "PB 5 network 2", "12", "PB 5 word 4"})
    EXPECT_EQ(find(text), "PB 5 word 4 (press.s5:13)") << text;
  EXPECT_EQ(find("FB 5"), "FB 5 word 0 (press.s5:18)");
  EXPECT_EQ(find("PB 5 nw 1"), "PB 5 word 0 (press.s5:9)");
}

// A word of a constant or of a parameter list stands for its instruction.
TEST_F(Step5Places, ContainTheWordsOfTheirInstruction) {
  EXPECT_EQ(find("PB 5 word 1"), "PB 5 word 0 (press.s5:9)");
  EXPECT_EQ(find("OB 1 word 2"), "OB 1 word 1 (press.s5:3)");
  EXPECT_EQ(find("OB 1 word 3"), "OB 1 word 1 (press.s5:3)");
  EXPECT_EQ(find("OB 1 word 4"), "OB 1 word 4 (press.s5:6)");
}

TEST_F(Step5Places, ThatAreWrongSayWhy) {
  EXPECT_EQ(find("FC 1"), "P1201");  // STEP 5 has no FC
  EXPECT_EQ(find("PB 5 byte 1"), "P1201");
  EXPECT_EQ(find("PB 5 word 90"), "P1308");  // it has fewer
  EXPECT_EQ(find("other.s5:3"), "P1202");
  EXPECT_EQ(find("PB 5:18"), "P1203");
  EXPECT_EQ(find("21"), "P1204");  // a value of a data block
  EXPECT_EQ(find("PB 5 network 3"), "P1205");
  EXPECT_EQ(find("SB 5"), "P1206");
  EXPECT_EQ(find("DB 10"), "P1207");
}

TEST_F(Step5Places, KnowStatementsAndNetworks) {
  const mc5::Block& pb = block(mc5::BlockType::Pb, 5);
  EXPECT_EQ(statementAt(pb, 1), (Statement{0, 2, 9, 4}));
  EXPECT_TRUE(beginsStatement(pb, 2));
  EXPECT_FALSE(beginsStatement(pb, 1));
  EXPECT_FALSE(endsBlock(pb, 5));  // BE is in the source
  EXPECT_EQ(networkAt(pb, 2), 1u);
  EXPECT_EQ(networkAt(pb, 4), 2u);
  EXPECT_EQ(statementNumber(pb, 2), 2u);
  EXPECT_EQ(statementNumber(pb, 5), 2u);
  EXPECT_EQ(networkAt(block(mc5::BlockType::Ob, 1), 4), 1u);
  EXPECT_EQ(toString(sourcePlace(program, {BlockKind::SB, 9}, 3)), "SB 9 word 3");
}

// S5-BLK-08: five words of header.
TEST_F(Step5Places, BlocksAreListed) {
  std::string text;
  for (const BlockRow& row : blockList(program))
    text += toString(row.id) + " " + row.symbol + " " + std::to_string(row.load) + " " +
            std::to_string(row.work) + "; ";
  EXPECT_EQ(text, "OB 1  11 6; PB 5  11 6; FB 5 VENTIL 7 2; DB 10  6 1; ");
}

}  // namespace
}  // namespace merker::monitor::test
