// What the programmer shows of a STOP: control bits, interrupt stack, block stack, fine coding
// (chapters 8.2, 8.3).
#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockId;
using mc5::BlockType;

const std::string kDeep = R"(OB 1
 A DB 10
 SPA PB 5
 BE
PB 5
 A DB 11
 L KF +7
 L KH 1234
 U M 0.1
 SPA FB 2
NAME : UNTEN
 BE
FB 2
NAME : UNTEN
 L KH ABCD
 T MW 100
 L KB 9
 -F
 STS
 BE
DB 10
0: KH = 0000
DB 11
0: KH = 0000
1: KH = 0000
)";

// S5-ERR-06, S5-ERR-08, S5-STAT-01, S5-NUM-01: fields of the interrupt stack.
TEST(StopScreen, InterruptStack) {
  ListingBench b(kDeep);
  b.run(1);
  ASSERT_TRUE(b.stopped(Alarm::Sts));
  const auto picture = b.plc().programmer().stopPicture();
  ASSERT_TRUE(picture.has_value());
  const InterruptStack& s = picture->interrupt;
  EXPECT_EQ(s.depth, 1u);
  EXPECT_EQ(s.block, (BlockId{BlockType::Fb, 2}));
  EXPECT_EQ(s.caller, (BlockId{BlockType::Pb, 5}));
  EXPECT_EQ(s.dataBlock, 11);
  EXPECT_EQ(s.dataLength, 2u);
  EXPECT_EQ(s.instruction, 0x7000u);
  EXPECT_EQ(s.relativeStep, 6u);  // behind STS
  const Entry& fb = b.plc().machine().blocks.find({BlockType::Fb, 2});
  EXPECT_EQ(s.blockAddress, fb.start * 2);
  EXPECT_EQ(s.stepAddress, fb.start * 2 + 12);
  EXPECT_EQ(s.dataAddress, b.plc().machine().blocks.find({BlockType::Db, 11}).start * 2);
  EXPECT_EQ(s.akku1 & 0xFFFF, 0xABC4u);
  EXPECT_EQ(s.displays & 0x02, 0x02);  // VKE
  EXPECT_EQ(s.displays & 0xC0, 0x40);  // negative
  const std::string text = toString(s);
  for (const char* part :
       {"TIEFE: 01", "BEF-REG: 7000", "XX-NR.: FB 2", "YY-NR.: PB 5", "DB-NR.: DB 11",
        "REL-SAZ: 0006", "DBL-REG: 0002", "UAMK: 0004", "ANZ1=0 ANZ0=1 OVFL=0 OVFLS=0 ODER=0",
        "STOPS=0 STUEB=0 NAU=0 QVZ=0 ZYK=0 BAU=0 SUF=0 STUEU=0 ADF=0 PARI=0 TRAF=0"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

// S5-ERR-10: what waits for a return, from the innermost on.
TEST(StopScreen, BlockStack) {
  ListingBench b(kDeep);
  b.run(1);
  const auto picture = b.plc().programmer().stopPicture();
  ASSERT_TRUE(picture.has_value());
  ASSERT_EQ(picture->blocks.size(), 2u);
  EXPECT_EQ(picture->interrupt.blockStackPointer, 2u);
  EXPECT_EQ(picture->blocks[0].block, (BlockId{BlockType::Pb, 5}));
  EXPECT_EQ(picture->blocks[0].dataBlock, 11);
  EXPECT_EQ(picture->blocks[0].relative, 7u);
  EXPECT_EQ(picture->blocks[1].block, (BlockId{BlockType::Ob, 1}));
  EXPECT_EQ(picture->blocks[1].dataBlock, 10);
  EXPECT_EQ(picture->blocks[1].relative, 2u);
  EXPECT_EQ(picture->blocks[1].returnAddress,
            b.plc().machine().blocks.find({BlockType::Ob, 1}).start * 2 + 4);
  EXPECT_NE(toString(picture->blocks).find("PB 5"), std::string::npos);
}

// S5-BLK-07, S5-ERR-09: an overflow shows twelve entries.
TEST(StopScreen, OverflowOfTheBlockStack) {
  std::string text = "OB 1\n SPA PB 1\n BE\n";
  for (int i = 1; i <= 12; ++i)
    text += "PB " + std::to_string(i) + "\n SPA PB " + std::to_string(i + 1) + "\n BE\n";
  ListingBench b(text + "PB 13\n BE\n");
  b.run(1);
  ASSERT_TRUE(b.stopped(Alarm::BlockStack));
  EXPECT_EQ(b.plc().programmer().stopPicture()->blocks.size(), 12u);
}

// S5-ERR-06: the pictures exist in STOP only; S5-ERR-07: the matrix as eight rows.
TEST(StopScreen, ControlBits) {
  ListingBench b(kDeep);
  EXPECT_TRUE(b.plc().programmer().stopPicture().has_value());
  ListingBench runs("OB 1\n BE\n");
  runs.run(70);
  EXPECT_FALSE(runs.plc().programmer().stopPicture().has_value());
  const std::string text = runs.plc().programmer().controlBitText();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 8);
  EXPECT_NE(
      text.find("NB         NB         BSTSCH=0   SCHTAE=0   ADRBAU=1   SPABBR=0   NAUAS=0    NB"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("STOZUS=0   STOANZ=0   NEUSTA=1   WIEDAN=0   BATPUF=1"), std::string::npos);
  EXPECT_NE(text.find("LIR/TIR=0"), std::string::npos);
  b.run(1);
  EXPECT_NE(b.plc().programmer().controlBitText().find("STOZUS=1   STOANZ=1   NEUSTA=1"),
            std::string::npos);
}

// S5-ERR-07: each bit has its place of the matrix, and no two share one.
TEST(StopScreen, PlacesOfTheControlBits) {
  EXPECT_EQ(controlBitRows().size(), 35u);
  std::array<unsigned, 9> seen{};
  for (const ControlBitRow& r : controlBitRows()) {
    EXPECT_EQ(seen[r.byte] >> r.bit & 1, 0u) << r.name;
    seen[r.byte] |= 1u << r.bit;
    ControlBits bits;
    bits.set(r.id);
    for (unsigned byte = 1; byte <= 8; ++byte)
      EXPECT_EQ(bits.row(byte), byte == r.byte ? 1u << r.bit : 0u) << r.name;
  }
  const std::array<unsigned, 9> matrix{0, 0x3E, 0x30, 0xF8, 0xF2, 0x2F, 0xFF, 0x3C, 0x40};
  EXPECT_EQ(seen, matrix);
}

// S5-ERR-07: bits of the state: start-up with OB 20, process alarm byte, battery.
TEST(StopScreen, BitsOfTheState) {
  ListingBench b("OB 20\n" + burn(5) + " BE\nOB 1\n BE\n");
  b.run(2);
  EXPECT_TRUE(b.control(ControlBit::OBWIED));
  EXPECT_TRUE(b.control(ControlBit::EOVH));
  b.runTo(20);
  EXPECT_FALSE(b.control(ControlBit::OBWIED));
  EXPECT_TRUE(b.control(ControlBit::BATPUF));
  b.plc().surroundings().batteryGood = false;
  EXPECT_FALSE(b.control(ControlBit::BATPUF));
  ListingBench none("OB 1\n BE\n");
  none.options.surroundings.modules = {};
  none.run(10);
  EXPECT_FALSE(none.control(ControlBit::EOVH));
}

// S5-ERR-16: bit 2 is the battery.
TEST(StopScreen, ControlRegister) {
  ListingBench b("OB 1\n BE\n");
  b.run(10);
  b.plc().stop();
  EXPECT_EQ(b.plc().programmer().stopPicture()->interrupt.controlRegister, 0x0004);
  b.plc().surroundings().batteryGood = false;
  b.plc().coldStart();
  b.plc().stop();
  EXPECT_EQ(b.plc().programmer().stopPicture()->interrupt.controlRegister & 4, 0);
}

// S5-ERR-15: a cold start clears the words, a warm restart keeps the counter.
TEST(StopScreen, FineCodingAfterAStart) {
  ListingBench b("OB 1\n U E 0.0\n SPB PB 9\n BE\n");
  b.run(10);
  b.write("E 0.0", 1);
  b.runTo(70);
  ASSERT_TRUE(b.stopped(Alarm::MissingBlock));
  EXPECT_EQ(b.address(0xF000), 0x0069u);
  EXPECT_EQ(b.address(0xF001), 0x6105u);
  EXPECT_EQ(b.address(0xF004), 0x0009u);
  for (unsigned index = 6; index <= 11; ++index) EXPECT_EQ(b.address(0xF000 + index), 0u);
  b.write("E 0.0", 0);
  b.plc().coldStart();
  for (unsigned index = 0; index <= 5; ++index) EXPECT_EQ(b.address(0xF000 + index), 0u);
}

// The reason names block and place, and the history keeps it.
TEST(StopScreen, Diagnosis) {
  ListingBench b(kDeep);
  b.run(1);
  EXPECT_EQ(b.plc().stopReason(), "6111 MC5-Befehl STS (instruction STS), FB 2 word 6");
  const auto& history = b.plc().diagnostics();
  ASSERT_GE(history.size(), 3u);
  EXPECT_EQ(history.back().number, 6111u);
  EXPECT_EQ(history.back().text, "STOP: " + b.plc().stopReason());
  EXPECT_EQ(history.front().text, "Neustart (cold start)");
}

}  // namespace
}  // namespace merker::sinumerik
