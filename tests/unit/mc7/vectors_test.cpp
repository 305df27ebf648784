// Literal codes from MC7 sections 2 to 6, never rebuilt from the table.
#include "vectors.h"

#include <gtest/gtest.h>

#include "mc7/encoding.h"

namespace merker::mc7 {
namespace {

std::vector<std::uint8_t> fromHex(std::string_view hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(
        static_cast<std::uint8_t>(std::stoi(std::string{hex.substr(i, 2)}, nullptr, 16)));
  return bytes;
}

}  // namespace

void checkVectors(std::span<const Vector> vectors) {
  for (const Vector& vector : vectors) {
    const auto bytes = fromHex(vector.code);
    const auto decoded = decode(bytes);
    ASSERT_TRUE(decoded) << vector.code << " " << vector.de;
    EXPECT_EQ(decoded->length, bytes.size()) << vector.code;
    EXPECT_EQ(text(decoded->instruction, Mnemonics::German), vector.de) << vector.code;
    EXPECT_EQ(text(decoded->instruction, Mnemonics::International), vector.en) << vector.code;
    std::vector<std::uint8_t> again;
    EXPECT_TRUE(encode(decoded->instruction, again)) << vector.code;
    EXPECT_EQ(again, bytes) << vector.code << " " << vector.de;
  }
}

namespace {

// Section 2; S7-INSTR-02 … 07, 18 … 22.
constexpr Vector kBitLogic[] = {
    {"8005", "U     M 5.0", "A     M 5.0"},
    {"8AFF", "O     M 255.2", "O     M 255.2"},
    {"9303", "S     M 3.3", "S     M 3.3"},
    {"9C04", "=     M 4.4", "=     M 4.4"},
    {"A501", "UN    M 1.5", "AN    M 1.5"},
    {"AE02", "ON    M 2.6", "ON    M 2.6"},
    {"B700", "R     M 0.7", "R     M 0.7"},
    {"C000", "U     E 0.0", "A     I 0.0"},
    {"C17F", "U     E 127.1", "A     I 127.1"},
    {"C180", "U     A 0.1", "A     Q 0.1"},
    {"C903", "O     E 3.1", "O     I 3.1"},
    {"D284", "S     A 4.2", "S     Q 4.2"},
    {"D884", "=     A 4.0", "=     Q 4.0"},
    {"E701", "UN    E 1.7", "AN    I 1.7"},
    {"E881", "ON    A 1.0", "ON    Q 1.0"},
    {"F2FF", "R     A 127.2", "R     Q 127.2"},
    {"00100080", "U     E 128.0", "A     I 128.0"},
    {"00270080", "U     A 128.7", "A     Q 128.7"},
    {"00310100", "U     M 256.1", "A     M 256.1"},
    {"00420002", "U     DBX 2.2", "A     DBX 2.2"},
    {"00530004", "U     DIX 4.3", "A     DIX 4.3"},
    {"00640006", "U     L 6.4", "A     L 6.4"},
    {"00E00000", "UN    L 0.0", "AN    L 0.0"},
    {"00C10003", "UN    DBX 3.1", "AN    DBX 3.1"},
    {"01B70100", "ON    M 256.7", "ON    M 256.7"},
    {"01410000", "O     DBX 0.1", "O     DBX 0.1"},
    {"05110000", "X     E 0.1", "X     I 0.1"},
    {"05A20005", "XN    A 5.2", "XN    Q 5.2"},
    {"09540008", "S     DIX 8.4", "S     DIX 8.4"},
    {"09E60009", "R     L 9.6", "R     L 9.6"},
    {"4147FFFF", "=     DBX 65535.7", "=     DBX 65535.7"},
    {"49300010", "FP    M 16.0", "FP    M 16.0"},
    {"49B10010", "FN    M 16.1", "FN    M 16.1"},
    {"51310004", "U     E [MD 4]", "A     I [MD 4]"},
    {"513A0004", "O     A [MD 4]", "O     Q [MD 4]"},
    {"51C30008", "UN    M [DBD 8]", "AN    M [DBD 8]"},
    {"51DC000C", "ON    DBX [DID 12]", "ON    DBX [DID 12]"},
    {"58650010", "X     DIX [LD 16]", "X     DIX [LD 16]"},
    {"583E0000", "S     L [MD 0]", "S     L [MD 0]"},
    {"58B10002", "XN    E [MD 2]", "XN    I [MD 2]"},
    {"58EA0004", "R     A [LD 4]", "R     Q [LD 4]"},
    {"59320006", "=     A [MD 6]", "=     Q [MD 6]"},
    {"594B0008", "FP    M [DBD 8]", "FP    M [DBD 8]"},
    {"59CB0008", "FN    M [DBD 8]", "FN    M [DBD 8]"},
    {"79100010", "U     E [AR1,P#2.0]", "A     I [AR1,P#2.0]"},
    {"79190011", "UN    E [AR2,P#2.1]", "AN    I [AR2,P#2.1]"},
    {"7952FFFF", "O     DIX [AR1,P#8191.7]", "O     DIX [AR1,P#8191.7]"},
    {"795B0000", "ON    DIX [AR2,P#0.0]", "ON    DIX [AR2,P#0.0]"},
    {"79340000", "X     M [AR1,P#0.0]", "X     M [AR1,P#0.0]"},
    {"794D0003", "XN    DBX [AR2,P#0.3]", "XN    DBX [AR2,P#0.3]"},
    {"79A00000", "S     A [AR1,P#0.0]", "S     Q [AR1,P#0.0]"},
    {"79D90020", "R     DIX [AR2,P#4.0]", "R     DIX [AR2,P#4.0]"},
    {"79E20008", "=     L [AR1,P#1.0]", "=     L [AR1,P#1.0]"},
    {"79B40000", "FP    M [AR1,P#0.0]", "FP    M [AR1,P#0.0]"},
    {"79BD0001", "FN    M [AR2,P#0.1]", "FN    M [AR2,P#0.1]"},
    {"FB100010", "U     [AR1,P#2.0]", "A     [AR1,P#2.0]"},
    {"FB1D0001", "XN    [AR2,P#0.1]", "XN    [AR2,P#0.1]"},
    {"FB220000", "=     [AR1,P#0.0]", "=     [AR1,P#0.0]"},
    {"FB290000", "R     [AR2,P#0.0]", "R     [AR2,P#0.0]"},
    {"FB250000", "FN    [AR1,P#0.0]", "FN    [AR1,P#0.0]"},
};
TEST(Vectors, BitLogic) { checkVectors(kBitLogic); }

// Section 2 and 2.1; S7-INSTR-08 … 11, 23 … 25.
constexpr Vector kBracketsAndStatus[] = {
    {"BA00", "U(", "A("},
    {"BB00", "O(", "O("},
    {"FFF1", "UN(", "AN("},
    {"FFF3", "ON(", "ON("},
    {"FFF4", "X(", "X("},
    {"FFF5", "XN(", "XN("},
    {"BF00", ")", ")"},
    {"FB00", "O", "O"},
    {"681C", "CLR", "CLR"},
    {"681D", "SET", "SET"},
    {"682D", "NOT", "NOT"},
    {"682C", "SAVE", "SAVE"},
    {"FF00", "U     OS", "A     OS"},
    {"FF11", "UN    OV", "AN    OV"},
    {"FF22", "O     >0", "O     >0"},
    {"FF43", "ON    <0", "ON    <0"},
    {"FF54", "X     UO", "X     UO"},
    {"FF65", "XN    <>0", "XN    <>0"},
    {"FF80", "U     ==0", "A     ==0"},
    {"FFA0", "U     >=0", "A     >=0"},
    {"FFC1", "UN    <=0", "AN    <=0"},
    {"FFE0", "U     BIE", "A     BR"},
};
TEST(Vectors, BracketsAndStatusBits) { checkVectors(kBracketsAndStatus); }

// Section 3; S7-INSTR-38, 40, 45, 46, 49, 50.
constexpr Vector kLoadAndTransfer[] = {
    {"0A0A", "L     MB 10", "L     MB 10"},
    {"120A", "L     MW 10", "L     MW 10"},
    {"1AFC", "L     MD 252", "L     MD 252"},
    {"0B00", "T     MB 0", "T     MB 0"},
    {"1302", "T     MW 2", "T     MW 2"},
    {"1B04", "T     MD 4", "T     MD 4"},
    {"4A01", "L     EB 1", "L     IB 1"},
    {"4A81", "L     AB 1", "L     QB 1"},
    {"527E", "L     EW 126", "L     IW 126"},
    {"5A84", "L     AD 4", "L     QD 4"},
    {"4B80", "T     AB 0", "T     QB 0"},
    {"5300", "T     EW 0", "T     IW 0"},
    {"5BFC", "T     AD 124", "T     QD 124"},
    {"7E010100", "L     PEB 256", "L     PIB 256"},
    {"7E020120", "L     PEW 288", "L     PIW 288"},
    {"7E030000", "L     PED 0", "L     PID 0"},
    {"7E050100", "T     PAB 256", "T     PQB 256"},
    {"7E060120", "T     PAW 288", "T     PQW 288"},
    {"7E070000", "T     PAD 0", "T     PQD 0"},
    {"7E410003", "L     DBB 3", "L     DBB 3"},
    {"7E420004", "L     DBW 4", "L     DBW 4"},
    {"7E530008", "L     DID 8", "L     DID 8"},
    {"7E660014", "T     LW 20", "T     LW 20"},
    {"7E370100", "T     MD 256", "T     MD 256"},
    {"7E120080", "L     EW 128", "L     IW 128"},
    {"BE420010", "L     DBW [AR1,P#2.0]", "L     DBW [AR1,P#2.0]"},
    {"BE590000", "L     DIB [AR2,P#0.0]", "L     DIB [AR2,P#0.0]"},
    {"BE670000", "T     LD [AR1,P#0.0]", "T     LD [AR1,P#0.0]"},
    {"BE0E0008", "T     PAW [AR2,P#1.0]", "T     PQW [AR2,P#1.0]"},
    {"BE020008", "L     PEW [AR1,P#1.0]", "L     PIW [AR1,P#1.0]"},
    {"FB010000", "L     B [AR1,P#0.0]", "L     B [AR1,P#0.0]"},
    {"FB020010", "L     W [AR1,P#2.0]", "L     W [AR1,P#2.0]"},
    {"FB030000", "L     D [AR1,P#0.0]", "L     D [AR1,P#0.0]"},
    {"FB090000", "L     B [AR2,P#0.0]", "L     B [AR2,P#0.0]"},
    {"FB0A0000", "L     W [AR2,P#0.0]", "L     W [AR2,P#0.0]"},
    {"FB0B0000", "L     D [AR2,P#0.0]", "L     D [AR2,P#0.0]"},
    {"FB060010", "T     W [AR1,P#2.0]", "T     W [AR1,P#2.0]"},
    {"FB0F0000", "T     D [AR2,P#0.0]", "T     D [AR2,P#0.0]"},
    {"BA330004", "L     MB [MD 4]", "L     MB [MD 4]"},
    {"BAC10004", "T     EB [DBD 4]", "T     IB [DBD 4]"},
    {"BA300004", "L     PEB [MD 4]", "L     PIB [MD 4]"},
    {"BAB00004", "T     PAB [MD 4]", "T     PQB [MD 4]"},
    {"BB430004", "L     MW [DBD 4]", "L     MW [DBD 4]"},
    {"BB4B0004", "L     MD [DBD 4]", "L     MD [DBD 4]"},
    {"BBE20008", "T     AW [LD 8]", "T     QW [LD 8]"},
    {"BBDC000A", "T     DBD [DID 10]", "T     DBD [DID 10]"},
    {"BBB80000", "T     PAD [MD 0]", "T     PQD [MD 0]"},
    {"7006", "L     STW", "L     STW"},
    {"7007", "T     STW", "T     STW"},
    {"FB3C", "L     DBLG", "L     DBLG"},
    {"FB3D", "L     DILG", "L     DILG"},
    {"FB4C", "L     DBNO", "L     DBNO"},
    {"FB4D", "L     DINO", "L     DINO"},
};
TEST(Vectors, LoadAndTransfer) { checkVectors(kLoadAndTransfer); }

// Section 3, constants; S7-TYPES-05 … 16.
constexpr Vector kConstants[] = {
    {"28A1", "L     B#16#A1", "L     B#16#A1"},
    {"30030005", "L     5", "L     5"},
    {"3003D0A5", "L     -12123", "L     -12123"},
    {"30056162", "L     'ab'", "L     'ab'"},
    {"30065136", "L     B#(81,54)", "L     B#(81,54)"},
    {"3007ABCD", "L     W#16#ABCD", "L     W#16#ABCD"},
    {"30080128", "L     C#128", "L     C#128"},
    {"300A0BD1", "L     D#1998-04-14", "L     D#1998-04-14"},
    {"300C3422", "L     S5T#1H10M20S", "L     S5T#1H10M20S"},
    {"38014144CCCD", "L     1.230000e+001", "L     1.230000e+001"},
    {"380300008A6A", "L     L#35434", "L     L#35434"},
    {"380400000050", "L     P#10.0", "L     P#10.0"},
    {"380761626364", "L     DW#16#61626364", "L     DW#16#61626364"},
    {"380561626364", "L     'abcd'", "L     'abcd'"},
    {"38060C0D0E0F", "L     B#(12,13,14,15)", "L     B#(12,13,14,15)"},
    {"380B03D6A015", "L     TOD#17:53:17.333", "L     TOD#17:53:17.333"},
};
TEST(Vectors, Constants) { checkVectors(kConstants); }

// Section 4; S7-INSTR-26 … 37, 39.
constexpr Vector kTimersAndCounters[] = {
    {"0205", "L     T 5", "L     T 5"},
    {"0C05", "LC    T 5", "LC    T 5"},
    {"0405", "FR    T 5", "FR    T 5"},
    {"1405", "SA    T 5", "SF    T 5"},
    {"1C05", "SV    T 5", "SE    T 5"},
    {"2405", "SE    T 5", "SD    T 5"},
    {"2C05", "SS    T 5", "SS    T 5"},
    {"3405", "SI    T 5", "SP    T 5"},
    {"3C05", "R     T 5", "R     T 5"},
    {"F8FF", "U     T 255", "A     T 255"},
    {"FC01", "UN    T 1", "AN    T 1"},
    {"F901", "O     T 1", "O     T 1"},
    {"FD01", "ON    T 1", "ON    T 1"},
    {"4203", "L     Z 3", "L     C 3"},
    {"4C03", "LC    Z 3", "LC    C 3"},
    {"4403", "FR    Z 3", "FR    C 3"},
    {"5403", "ZR    Z 3", "CD    C 3"},
    {"5C03", "S     Z 3", "S     C 3"},
    {"6C03", "ZV    Z 3", "CU    C 3"},
    {"7C03", "R     Z 3", "R     C 3"},
    {"B803", "U     Z 3", "A     C 3"},
    {"BC03", "UN    Z 3", "AN    C 3"},
    {"B903", "O     Z 3", "O     C 3"},
    {"BD03", "ON    Z 3", "ON    C 3"},
    {"FBE00100", "U     T 256", "A     T 256"},
    {"FBE40005", "X     T 5", "X     T 5"},
    {"FBEC0100", "SE    T 256", "SD    T 256"},
    {"FBF50005", "XN    Z 5", "XN    C 5"},
    {"FBFD0100", "ZV    Z 256", "CU    C 256"},
    {"FBFA0100", "ZR    Z 256", "CD    C 256"},
    {"BF3C0004", "SE    T [MW 4]", "SD    T [MW 4]"},
    {"BF400006", "U     T [DBW 6]", "A     T [DBW 6]"},
    {"BF6F0002", "R     T [LW 2]", "R     T [LW 2]"},
    {"BFBD0004", "ZV    Z [MW 4]", "CU    C [MW 4]"},
    {"BFDB0000", "S     Z [DIW 0]", "S     C [DIW 0]"},
    {"FBAC0002", "SE    T #P0", "SD    T #P0"},
    {"FBA00004", "U     T #P1", "A     T #P1"},
    {"FBBD0006", "ZV    Z #P2", "CU    C #P2"},
};
TEST(Vectors, TimersAndCounters) { checkVectors(kTimersAndCounters); }

}  // namespace
}  // namespace merker::mc7
