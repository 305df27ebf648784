#include "address/constant.h"

#include <gtest/gtest.h>

#include <ostream>

namespace merker {
namespace {

using enum ConstantFormat;

struct Good {
  std::string_view text;
  ConstantFormat format;
  std::uint32_t bits;
};
void PrintTo(const Good& good, std::ostream* out) { *out << good.text; }

class Reads : public testing::TestWithParam<Good> {};

TEST_P(Reads, formatAndBits) {
  const auto constant = parseConstant(GetParam().text, {});
  ASSERT_TRUE(constant) << constant.error().message;
  EXPECT_EQ(constant->format, GetParam().format);
  EXPECT_EQ(constant->bits, GetParam().bits) << std::hex << constant->bits;
}

// The worked numbers of the requirements, S7-TYPES-05 to -16 and S7-LOAD-06 to -15.
INSTANTIATE_TEST_SUITE_P(
    Requirements, Reads,
    testing::Values(
        Good{"B#16#A1", Byte, 0xA1}, Good{"'T'", Characters, 0x54}, Good{"W#16#ABCD", Word, 0xABCD},
        Good{"2#00110011_11110000", Binary, 0x33F0}, Good{"C#128", Counter, 0x128},
        Good{"B#(81, 54)", Bytes, 0x5136}, Good{"-12123", Integer, 0xD0A5},
        Good{"S5T#1h10m20s", S5Time, 0x3422}, Good{"D#1998-04-14", Date, 0x0BD1},
        Good{"DW#16#1234_5678", DWord, 0x12345678},
        Good{"2#10001000_10011001_11110000_11110000", LongBinary, 0x8899F0F0},
        Good{"B#(12, 13, 14, 15)", LongBytes, 0x0C0D0E0F}, Good{"L#35434", LongInteger, 0x8A6A},
        Good{"12.3", Real, 0x4144CCCD}, Good{"1.230000e+01", Real, 0x4144CCCD},
        Good{"T#14d20h45m23s123ms", Time, 1284323123},
        Good{"TOD#17:53:17.333", TimeOfDay, 64397333}, Good{"B#16#AA", Byte, 0xAA},
        Good{"'A'", Characters, 0x41}, Good{"'ABCD'", LongCharacters, 0x41424344},
        Good{"2230", Integer, 0x08B6}, Good{"W#16#AB12", Word, 0xAB12},
        Good{"L#3453600", LongInteger, 0x0034B2A0}, Good{"DW#16#AAAABBBB", DWord, 0xAAAABBBB},
        Good{"1.245600e+01", Real, 0x41474BC7}, Good{"S5T#3M20S", S5Time, 0x2200},
        Good{"T#2D3M20S", Time, 0x0A4FC540}, Good{"T#1D5M", Time, 86700000},
        Good{"TOD#12:23:45.0", TimeOfDay, 0x02A8EC68}, Good{"TOD#12:23:45", TimeOfDay, 44625000}));

INSTANTIATE_TEST_SUITE_P(
    Spellings, Reads,
    testing::Values(Good{"w#16#ab", Word, 0xAB}, Good{"WORD#16#1F", Word, 0x1F},
                    Good{"byte#16#1f", Byte, 0x1F}, Good{"dword#16#1_2", DWord, 0x12},
                    Good{"BYTE#(1,2)", Bytes, 0x102}, Good{"C#010", Counter, 0x10},
                    Good{"C# 100", Counter, 0x100}, Good{"W # 16 # FF", Word, 0xFF},
                    Good{"  5 ", Integer, 5}, Good{"+5", Integer, 5}, Good{"- 5", Integer, 0xFFFB},
                    Good{"1_000", Integer, 1000}, Good{"L#-5", LongInteger, 0xFFFFFFFB},
                    Good{"L# +5", LongInteger, 5}, Good{"2#1010_1010", Binary, 0xAA},
                    Good{"2#1_00000000_00000000", LongBinary, 0x10000}, Good{"16#FF", Byte, 0xFF},
                    Good{"16#0FF", Word, 0xFF}, Good{"16#0_0000", DWord, 0},
                    Good{"true", Boolean, 1}, Good{"FALSE", Boolean, 0},
                    Good{"B# ( 255 ,0 )", Bytes, 0xFF00}));

INSTANTIATE_TEST_SUITE_P(
    Limits, Reads,
    testing::Values(Good{"32767", Integer, 0x7FFF}, Good{"-32768", Integer, 0x8000},
                    Good{"L#2147483647", LongInteger, 0x7FFFFFFF},
                    Good{"L#-2147483648", LongInteger, 0x80000000}, Good{"C#999", Counter, 0x999},
                    Good{"C#0", Counter, 0}, Good{"W#16#FFFF", Word, 0xFFFF},
                    Good{"DW#16#FFFFFFFF", DWord, 0xFFFFFFFF},
                    Good{"2#11111111_11111111_11111111_11111111", LongBinary, 0xFFFFFFFF},
                    Good{"P#65535.7", Pointer, 0x7FFFF}));

// S7-TYPES-14: to the nearest float, whatever the notation.
INSTANTIATE_TEST_SUITE_P(
    Reals, Reads,
    testing::Values(Good{"1e3", Real, 0x447A0000}, Good{"-1.5", Real, 0xBFC00000},
                    Good{"+1.5E0", Real, 0x3FC00000}, Good{"0.0", Real, 0},
                    Good{"0.000e-99", Real, 0}, Good{"-0.0", Real, 0x80000000},
                    Good{"1.175495e-38", Real, 0x00800005},
                    Good{"1.17549435e-38", Real, 0x00800000},
                    Good{"-3.402823e+38", Real, 0xFF7FFFFD},
                    Good{"3.40282347e+038", Real, 0x7F7FFFFF}, Good{"16777217.0", Real, 0x4B800000},
                    Good{"16777219.0", Real, 0x4B800002}, Good{"0.1", Real, 0x3DCCCCCD},
                    Good{"1_0.2_5", Real, 0x41240000}));

// S7-IND-01, -02, -08: one area each, with and without the blank.
INSTANTIATE_TEST_SUITE_P(
    Pointers, Reads,
    testing::Values(Good{"P#10.7", Pointer, 0x57}, Good{"P#E1.0", Pointer, 0x81000008},
                    Good{"P#I 1.0", Pointer, 0x81000008}, Good{"P#A 4.1", Pointer, 0x82000021},
                    Good{"P#Q4.1", Pointer, 0x82000021}, Good{"P#M 10.0", Pointer, 0x83000050},
                    Good{"p#m10.0", Pointer, 0x83000050}, Good{"P#DBX 10.0", Pointer, 0x84000050},
                    Good{"P#DIX10.0", Pointer, 0x85000050}, Good{"P#L 20.0", Pointer, 0x860000A0},
                    Good{"P#V 0.0", Pointer, 0x87000000}, Good{"P# P 256.0", Pointer, 0x80000800}));

INSTANTIATE_TEST_SUITE_P(
    CharacterConstants, Reads,
    testing::Values(Good{"'ab'", Characters, 0x6162}, Good{"'abc'", LongCharacters, 0x616263},
                    Good{"' '", Characters, 0x20}, Good{"'a_b'", LongCharacters, 0x615F62},
                    Good{"'$''", Characters, 0x27}, Good{"'$$'", Characters, 0x24},
                    Good{"'$L'", Characters, 0x0A}, Good{"'$n'", Characters, 0x0D0A},
                    Good{"'$P$r'", Characters, 0x0C0D}, Good{"'$T'", Characters, 0x09},
                    Good{"'$c4$00'", Characters, 0xC400}, Good{"'ä'", Characters, 0xE4},
                    Good{"'€'", Characters, 0x80}, Good{"'ÄÖÜß'", LongCharacters, 0xC4D6DCDF}));

struct Bad {
  std::string_view text;
  ProblemCode code;
};
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.text; }

class Refuses : public testing::TestWithParam<Bad> {};

TEST_P(Refuses, withCodeAndPlace) {
  const Position at{"a.awl", 3, 7, 2};
  const auto constant = parseConstant(GetParam().text, at);
  ASSERT_FALSE(constant);
  EXPECT_EQ(constant.error().name(), info(GetParam().code).name) << constant.error().message;
  EXPECT_EQ(constant.error().position, at);
}

using enum ProblemCode;

INSTANTIATE_TEST_SUITE_P(
    OutOfRange, Refuses,
    testing::Values(Bad{"32768", P0202}, Bad{"-32769", P0202}, Bad{"99999999999999999999", P0202},
                    Bad{"L#2147483648", P0202}, Bad{"L#-2147483649", P0202}, Bad{"C#1000", P0202},
                    Bad{"B#16#100", P0202}, Bad{"W#16#10000", P0202}, Bad{"DW#16#100000000", P0202},
                    Bad{"B#(256,0)", P0202}, Bad{"16#100000000", P0202},
                    Bad{"2#111111111111111111111111111111111", P0202}, Bad{"P#65536.0", P0202},
                    Bad{"P#0.8", P0202}, Bad{"3.402824e+38", P0202}, Bad{"-1e39", P0202},
                    Bad{"1.175494e-38", P0202}, Bad{"1e-38", P0202}, Bad{"1e-99", P0202},
                    Bad{"1e99999999", P0202}));

INSTANTIATE_TEST_SUITE_P(
    Misspelt, Refuses,
    testing::Values(Bad{"", P0201}, Bad{"abc", P0201}, Bad{"5 5", P0201}, Bad{"1.", P0201},
                    Bad{".5", P0201}, Bad{"1e", P0201}, Bad{"_5", P0201}, Bad{"5_", P0201},
                    Bad{"5__0", P0201}, Bad{"X#5", P0201}, Bad{"#", P0201}, Bad{"K#5", P0201},
                    Bad{"nan", P0201}, Bad{"--5", P0201}, Bad{"W#16#", P0205}, Bad{"W#16#G", P0205},
                    Bad{"W#FF", P0205}, Bad{"2#", P0205}, Bad{"2#12", P0205}, Bad{"B#(1)", P0205},
                    Bad{"B#(1,2,3)", P0205}, Bad{"B#(1,2,3,4,5)", P0205}, Bad{"B#(1,2", P0205},
                    Bad{"C#", P0205}, Bad{"C#-5", P0205}, Bad{"L#", P0205}, Bad{"L#1.0", P0205},
                    Bad{"P#M 10", P0205}, Bad{"P#X 1.0", P0205}, Bad{"P#", P0205},
                    Bad{"P#MB 1.0", P0205}, Bad{"P#M10.0x", P0205}));

// S7-LOAD-07: five characters rejected.
INSTANTIATE_TEST_SUITE_P(BadCharacters, Refuses,
                         testing::Values(Bad{"'ABCDE'", P0204}, Bad{"''", P0209}, Bad{"'ab", P0209},
                                         Bad{"'a'b'", P0209}, Bad{"'$q'", P0209}, Bad{"'$'", P0209},
                                         Bad{"'😀'", P0209}, Bad{"'", P0209}));

// S7-TYPES-17: DATE_AND_TIME is no constant of an instruction.
TEST(ParseConstant, dateAndTimeIsNotLoadable) {
  const auto constant = parseConstant("DT#1998-04-14-17:53:17.333", {});
  ASSERT_FALSE(constant);
  EXPECT_NE(constant.error().message.find("64 bits"), std::string::npos);
}

TEST(ParseConstant, messagesSayWhatWouldBeRight) {
  EXPECT_EQ(parseConstant("32768", {}).error().message,
            "32768 is outside -32768..32767 of INT; write a DINT with L#");
  EXPECT_EQ(parseConstant("P#M 10", {}).error().message,
            "P#M 10 must be written like P#10.0 or P#M 10.0 (areas E I A Q M DBX DIX L V P)");
}

TEST(ParseCharacters, anyLength) {
  EXPECT_EQ(*parseCharacters("'Dies ist ein String'", {}), "Dies ist ein String");  // S7-TYPES-19
  EXPECT_EQ(*parseCharacters("''", {}), "");
  EXPECT_EQ(formatCharacters("a'$\n\xE4\x81"), "'a$'$$$0Aä$81'");
}

}  // namespace
}  // namespace merker
