// Codes of the manual's table with their texts (9.5, S5-OPC-T1 to T3).
#include <gtest/gtest.h>

#include "mc5/disassembly.h"
#include "mc5/instruction.h"

namespace merker::mc5 {
namespace {

struct Row {
  std::vector<std::uint16_t> words;
  const char* text;
};

class CodeText : public testing::TestWithParam<Row> {};

// S5-OPC-01, S5-OPC-02, S5-BITTEST-04, S5-FB-16
TEST_P(CodeText, Prints) {
  const auto decoded = decode(GetParam().words);
  ASSERT_TRUE(decoded.has_value());
  EXPECT_EQ(decoded->words, GetParam().words.size());
  EXPECT_EQ(text(decoded->instruction), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(
    Table, CodeText,
    testing::Values(
        Row{{0xC30A}, "U     E 10.3"}, Row{{0xC492}, "U     A 18.4"}, Row{{0x833A}, "U     M 58.3"},
        Row{{0xBD1F}, "ON    Z 31"}, Row{{0xFC00}, "UN    T 0"}, Row{{0xFB00}, "O"},
        Row{{0xBA00}, "U("}, Row{{0xBB00}, "O("}, Row{{0xBF00}, ")"}, Row{{0x9A05}, "=     M 5.2"},
        Row{{0x783F, 0x6A37}, "=     D 55.10"}, Row{{0x783F, 0x2001}, "UN    D 1.0"},
        Row{{0x4A80}, "L     AB 0"}, Row{{0x4A7F}, "L     EB 127"}, Row{{0x1AFC}, "L     MD 252"},
        Row{{0x220F}, "L     DL 15"}, Row{{0x2A0F}, "L     DR 15"}, Row{{0x7A7E}, "L     PW 126"},
        Row{{0x7B02}, "T     PW 2"}, Row{{0x28FF}, "L     KB 255"},
        Row{{0x3040, 0x7F0A}, "L     KH 7F0A"}, Row{{0x3004, 0xFFFF}, "L     KF -1"},
        Row{{0x3002, 0x2010}, "L     KT 10.2"}, Row{{0x3001, 0x0100}, "L     KZ 100"},
        Row{{0x3010, 0x4631}, "L     KC F1"}, Row{{0x3020, 0x0102}, "L     KY 1,2"},
        Row{{0x3080, 0x3E5B}, "L     KM 00111110 01011011"},
        Row{{0x3800, 0x0140, 0x0000}, "L     KG +1000000+01"},
        Row{{0x3005, 0x1234}, "L     K#05 1234"}, Row{{0x3001, 0x00FF}, "L     K#01 00FF"},
        Row{{0x2402}, "SE    T 2"}, Row{{0x3C1F}, "R     T 31"}, Row{{0x5C05}, "S     Z 5"},
        Row{{0x6C28}, "ZV    Z 40"}, Row{{0x0401}, "FR    T 1"}, Row{{0x31A0}, ">=G"},
        Row{{0x31C0}, "<=G"}, Row{{0x2180}, "!=F"}, Row{{0x3960}, "><D"}, Row{{0x6004}, "xF"},
        Row{{0x50FD}, "ADD   BF -3"}, Row{{0x5800, 0x8000}, "ADD   KF -32768"},
        Row{{0x3DCB}, "SPA   FB 203"}, Row{{0x1DCB}, "SPB   FB 203"}, Row{{0x7D01}, "SPA   SB 1"},
        Row{{0x204D}, "A     DB 77"}, Row{{0x6501}, "BEA"}, Row{{0x10FF}, "BLD   255"},
        Row{{0xFFFF}, "NOP 1"}, Row{{0x7046, 0xCACD}, "P     D 205.10"},
        Row{{0x7038, 0x4184}, "SU    A 4.1"}, Row{{0x7015, 0x0F1F}, "RU    Z 31.15"},
        Row{{0x7049, 0x8000}, "PN    M 0.0"}, Row{{0x6841}, "SVW   4"}, Row{{0x7120}, "SVD   32"},
        Row{{0x2D04}, "SPA   =+4"}, Row{{0xFA81}, "SPB   =-127"},
        Row{{0x600C, 0x0002}, "SPS   =+2"}, Row{{0x4EFA}, "B     MW 250"},
        Row{{0x6E15}, "B     DW 21"}, Row{{0x7603}, "B     =3"}, Row{{0x0701}, "U     =1"},
        Row{{0x3701}, "RB    =1"}, Row{{0x2E02}, "SSV   =2"}, Row{{0x5605}, "LD    =5"},
        Row{{0x4802}, "TIR   2"}, Row{{0x030A}, "TNB   10"}));

// S5-OPC-09, S5-OPC-03: what is no instruction does not stop the listing.
TEST(Disassembly, GoesOnBehindIllegalWords) {
  const std::uint16_t code[] = {0x0800, 0x3040, 0x1234, 0x6500, 0x3040};
  const auto lines = disassemble(code);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(lines[0].illegal);
  EXPECT_EQ(toString(lines[1]), "0001: 3040 1234        L     KH 1234");
  EXPECT_EQ(lines[2].text, "BE");
  EXPECT_TRUE(lines[3].illegal);
}

}  // namespace
}  // namespace merker::mc5
