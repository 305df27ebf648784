// Rules that single tests left open.
#include <sstream>

#include "listing_bench.h"
#include "softplc/segments.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockId;
using mc5::BlockType;

// S5-BLK-09: all five words of the header, for each type of block (OP-02).
TEST(Rules, HeaderWords) {
  struct Row {
    BlockType type;
    unsigned code;
  };
  for (const Row& row :
       {Row{BlockType::Ob, 0x50}, Row{BlockType::Pb, 0x44}, Row{BlockType::Sb, 0x42},
        Row{BlockType::Fb, 0x48}, Row{BlockType::Db, 0x41}}) {
    BlockMemory memory(100, 100);
    mc5::Block b;
    b.id = {row.type, 25};
    b.library = 0x12345;
    b.words = {0xABCD, 0x6500};
    ASSERT_TRUE(memory.load(b));
    const auto& words = row.type == BlockType::Db ? memory.data() : memory.program();
    EXPECT_EQ(std::vector<std::uint16_t>(words.begin(), words.begin() + 7),
              (std::vector<std::uint16_t>{0x7070, static_cast<std::uint16_t>(row.code << 8 | 25),
                                          0x0001, 0x2345, 7, 0xABCD, 0x6500}));
    EXPECT_EQ(blockType(static_cast<std::uint8_t>(row.code)), row.type);
  }
}

// S5-MEM-05, S5-MEM-06: each pseudo address leads to the list of its own blocks.
TEST(Rules, BlockListsByTheirAddresses) {
  ListingBench b("OB 1\n BE\nPB 7\n BE\nSB 7\n BE\nFB 7\nNAME : TEST\n BE\nDB 7\n 0: KH = 0000\n");
  b.options.variant = mc5::Variant::Acop;
  b.run(10);
  struct Row {
    unsigned address;
    BlockId id;
  };
  for (const Row& row : {Row{0xF00C, {BlockType::Ob, 1}}, Row{0xF00D, {BlockType::Fb, 7}},
                         Row{0xF00E, {BlockType::Db, 7}}, Row{0xF010, {BlockType::Sb, 7}},
                         Row{0xF011, {BlockType::Pb, 7}}}) {
    const Machine& m = b.plc().machine();
    const unsigned list = b.address(row.address) * 2 + row.id.number * 4u;
    const unsigned swapped = readWord(m, 1, list).value_or(0);
    const unsigned offset = (swapped & 0xFF) << 8 | swapped >> 8;
    EXPECT_EQ(offset, m.blocks.find(row.id).start * 2) << std::hex << row.address;
  }
  EXPECT_EQ(b.address(0xF00F), 0u);
}

// PLC-MD 6 names the last timer that runs, this one included. S5-MD-02
TEST(Rules, TheTimerOfMd6Runs) {
  for (const unsigned last : {15u, 3u}) {
    const std::string t = std::to_string(last);
    ListingBench b("OB 1\n U M 0.1\n L KT 3.1\n SE T " + t + "\n U T " + t + "\n = M 100.0\n BE\n");
    b.data().setWord(6, static_cast<std::uint16_t>(last));
    b.run(1000);
    EXPECT_EQ(b.plc().mode(), Mode::Run);
    EXPECT_EQ(b.value("M 100.0"), 1u) << last;
  }
}

// S5-ERR-07, S5-ERR-T1: the names of the matrix, row by row as the manual prints them.
TEST(Rules, MatrixOfTheControlBits) {
  constexpr std::array<std::array<const char*, 8>, 8> kMatrix{
      {{"NB", "NB", "BSTSCH", "SCHTAE", "ADRBAU", "SPABBR", "NAUAS", "NB"},
       {"NB", "NB", "NNN", "PERUNKL", "NB", "NB", "NB", "NB"},
       {"STOZUS", "STOANZ", "NEUSTA", "WIEDAN", "BATPUF", "NB", "NB", "NB"},
       {"KEINPS", "UAFEHL", "MAFEHL", "EOVH", "NB", "NB", "OBWIED", "NB"},
       {"NB", "NB", "KOPFNI", "NB", "WECKFE", "PADRFE", "ASPLUE", "RAMADFE"},
       {"EAADFE", "SYNFEH", "NINEU", "NIWIED", "RUFBST", "QVZNIN", "SUMF", "URLAD"},
       {"NB", "NB", "STS", "STP", "TBWFEH", "LIR/TIR", "NB", "NB"},
       {"NB", "LPTP", "NB", "NB", "NB", "NB", "NB", "NB"}}};
  ListingBench b("OB 1\n BE\n");
  std::istringstream rows(b.plc().programmer().controlBitText());
  for (const auto& expected : kMatrix)
    for (const char* name : expected) {
      std::string cell;
      rows >> cell;
      EXPECT_EQ(cell.substr(0, cell.find('=')), name);
    }
}

// S5-MD-03: what the bits of MD 2003 and 2002 do, by number.
TEST(Rules, BitsOfMd2003) {
  constexpr const char* kAsks = "OB 1\n A DB 1\n U M 0.1\n = D 9.15\n BE\n";
  ListingBench diagnosis(kAsks);
  diagnosis.set(2003, 7);
  diagnosis.run(200);
  EXPECT_EQ(diagnosis.value("DB1.DW 0"), 60u);
  ListingBench none(kAsks);
  none.run(200);
  EXPECT_EQ(none.value("DB1.DW 0"), 0u);

  // chopping: OB 1 of 5 ms does not end within the first third
  for (const bool chopping : {false, true}) {
    ListingBench b("OB 1\n" + burn(5) + " BE\n");
    b.set(2003, 6, chopping);
    b.run(15);
    EXPECT_EQ(b.plc().cycles(), chopping ? 0u : 1u);
  }
  // warm restart when voltage returns
  for (const bool warm : {false, true}) {
    ListingBench b("OB 1\n BE\nOB 20\n U M 3.0\n = M 100.0\n BE\n");
    b.set(2003, 3, warm);
    b.run(100);
    b.plc().powerOff();
    b.plc().powerOn();
    b.runTo(300);
    EXPECT_EQ(b.control(ControlBit::WIEDAN), warm);
    EXPECT_EQ(b.value("M 100.0"), warm ? 0u : 1u);
  }
  // STOP when the distributed periphery is disturbed
  for (const bool stop : {false, true}) {
    ListingBench b("OB 1\n BE\n");
    b.set(2002, 4);
    b.set(2003, 2, stop);
    b.run(70);
    b.plc().surroundings().unit.transmission = false;
    b.runTo(200);
    EXPECT_EQ(b.plc().mode() == Mode::Stop, stop);
  }
}

// LIR fills AKKU 1 as every load does: bits that take no part are 0 (9.2, S5-SYS-02).
TEST(Rules, LirClearsTheHighWord) {
  ListingBench b(
      "OB 1\n SPA FB 1\nNAME : LESEN\n BE\nFB 1\nNAME : LESEN\n L KB 5\n T MW 100\n L KB 0\n"
      " T MW 102\n L MD 100\n LIR 0\n T MD 104\n BE\n");
  b.set(2003, 4);
  b.run(10);
  EXPECT_EQ(b.value("MD 104"), 0x00007070u);
}

// OB 2 of about 1.2 ms, twice 5 ms apart: more than 2 ms within 4 sampling times, wherever these
// begin (1.3.4, S5-SCHED-10).
TEST(Rules, RunTimeOfOb2InAnyFourSamplings) {
  for (int phase = 0; phase < 8; ++phase) {
    for (const double apart : {5.0, 15.0, 20.0}) {
      ListingBench b("OB 1\n BE\nOB 2\n" + burn(1.16) + " BE\n");
      b.run(102.5 + phase * 2.5);
      b.write("E 7.0", 1);
      b.runTo(102.5 + phase * 2.5 + apart);
      b.write("E 7.0", 0);
      b.runTo(200);
      EXPECT_EQ(b.stopped(Alarm::AlarmRunTime), apart < 20) << phase << ' ' << apart;
    }
  }
}

// 9.3.4, S5-TIMER-13: with VKE 0 SE T 33 behind B clears ZWG, ZKS and FMS of T 1; with VKE 1 it is
// the interpreter's and 6113.
TEST(Rules, NumbersBehindBReachOtherTimers) {
  const std::string program =
      "OB 1\n U M 0.1\n L KT 500.1\n SV T 1\n SPA FB 1\nNAME : FREMD\n BE\nFB 1\nNAME : FREMD\n"
      " L KF +33\n T MW 100\n U E 0.0\n SPB =HALT\n UN M 0.1\n B MW 100\n SE T 0\n"
      " P T 1.15\n = M 110.0\n P T 1.14\n = M 110.1\n P T 1.11\n = M 110.2\n L T 1\n T MW 112\n"
      " SPA =ENDE\nHALT : U M 0.1\n B MW 100\n SE T 0\nENDE : BE\n";
  ListingBench b(program);
  b.run(70);
  ASSERT_EQ(b.plc().mode(), Mode::Run) << b.plc().stopReason();
  EXPECT_EQ(b.value("MB 110"), 0u);
  EXPECT_EQ(b.value("MW 112"), 500u);  // the value is no control bit
  b.write("E 0.0", 1);
  b.runTo(200);
  EXPECT_TRUE(b.stopped(Alarm::TimerCounter));
  EXPECT_EQ(b.address(0xF004), 0x33u);
}

TEST(Rules, NumbersBehindBReachOtherCounters) {
  const std::string program =
      "OB 1\n L KZ 5\n U M 0.1\n S Z 1\n ZV Z 1\n SPA FB 1\nNAME : FREMD\n BE\nFB 1\n"
      "NAME : FREMD\n L KF +33\n T MW 100\n UN M 0.1\n B MW 100\n ZV Z 0\n U M 0.1\n ZV Z 1\n"
      " STP\n BE\n";
  ListingBench b(program);
  b.run(10);
  EXPECT_TRUE(b.stopped(Alarm::Stp)) << b.plc().stopReason();
  EXPECT_EQ(b.value("Z 1"), 7u);  // its edge was forgotten
}

// An OB 20 without end: nothing but time passes, and nobody waits for a cycle.
TEST(Rules, EndlessStartUp) {
  ListingBench b(
      "OB 1\n BE\nOB 20\n SPA FB 1\nNAME : LOOP\n BE\nFB 1\nNAME : LOOP\nM1 : SPA =M1\n"
      " BE\n");
  b.run(10);
  b.plc().settle();  // it may end soon
  EXPECT_GE(b.plc().now(), ms(200));
  EXPECT_LT(b.plc().now(), ms(201));
  const Instant before = b.plc().now();
  b.plc().settle();
  EXPECT_EQ(b.plc().now(), before);
  EXPECT_EQ(b.plc().mode(), Mode::Startup);
}

}  // namespace
}  // namespace merker::sinumerik
