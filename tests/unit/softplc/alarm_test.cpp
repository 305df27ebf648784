// Every alarm of chapter 8.4: its cause, number, text, reaction and the bits that show it.
#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockType;
constexpr const char* kEmpty = "OB 1\n BE\n";

// A function block with supplementary operations, called by OB 1.
std::string inFb(const std::string& body) {
  return "OB 1\n SPA FB 1\nNAME : PRUEF\n BE\nFB 1\nNAME : PRUEF\n" + body + " BE\n";
}

struct ProgramFault {
  Alarm alarm;
  std::string listing;
  ControlBit control;
  Cause cause;
  unsigned word1, word2, word3;  // F002 … F004
};

std::string chain(int blocks) {
  std::string text = "OB 1\n SPA PB 1\n BE\n";
  for (int i = 1; i <= blocks; ++i)
    text += "PB " + std::to_string(i) + "\n" +
            (i < blocks ? " SPA PB " + std::to_string(i + 1) + "\n" : "") + " BE\n";
  return text;
}

const ProgramFault kProgramFaults[] = {
    {Alarm::IllegalParameter,
     inFb(" L KF +200\n T MW 100\n B MW 100\n T MW 0\n L KF +255\n T MW 100\n"
          " B MW 100\n T MW 0\n"),
     ControlBit::NNN, Cause::NONE, 0x4E64, 0, 0x0255},
    {Alarm::TransferToMissingDb, "OB 1\n T DW 0\n BE\n", ControlBit::NONE, Cause::TRAF, 0x3300, 0,
     0},
    {Alarm::Substitution, inFb(" B MW 100\n BEA\n"), ControlBit::NONE, Cause::SUF, 0x4E64, 0, 0},
    {Alarm::MissingBlock, "OB 1\n SPA PB 200\n BE\n", ControlBit::RUFBST, Cause::NONE, 0x75C8, 0,
     0x0200},
    {Alarm::MissingDb, "OB 1\n A DB 77\n BE\n", ControlBit::NONE, Cause::NONE, 0x204D, 0, 0x0077},
    {Alarm::BlockStack, chain(12), ControlBit::NONE, Cause::STUEB, 0x750C, 0, 0},
    {Alarm::Sts, inFb(" STS\n"), ControlBit::STS, Cause::NONE, 0x7000, 0, 0},
    {Alarm::Stp, "OB 1\n STP\n BE\n", ControlBit::STP, Cause::NONE, 0, 0, 0},
    {Alarm::TimerCounter, "OB 1\n U M 0.1\n L KT 10.1\n SE T 20\n BE\n", ControlBit::NNN,
     Cause::NONE, 0x2414, 0, 0x0020},
    {Alarm::SystemCommandsLocked, inFb(" LIR 0\n"), ControlBit::NONE, Cause::NONE, 0x4000, 0, 0},
    {Alarm::NoAnswerPeriphery, "OB 1\n L PB 100\n BE\n", ControlBit::LPTP, Cause::QVZ, 0x7264,
     0x000E, 0x0100},
    {Alarm::CycleTime, inFb("M1 : SPA =M1\n"), ControlBit::NONE, Cause::ZYK, 0, 0, 0}};

// S5-ERR-07, S5-ERR-11, S5-ERR-12, S5-ERR-13, S5-ERR-14, S5-ERR-17, S5-PROC-06, S5-BLK-07: faults
// of the program, each with its words and bits.
TEST(Alarms, FaultsOfTheProgram) {
  for (const ProgramFault& fault : kProgramFaults) {
    ListingBench b(fault.listing);
    b.run(200);
    const unsigned n = number(fault.alarm);
    EXPECT_TRUE(b.stopped(fault.alarm)) << n << " but " << b.plc().stopReason();
    EXPECT_EQ(b.address(0xF000), n - 6000) << n;
    EXPECT_EQ(b.address(0xF002), fault.word1) << n;
    EXPECT_EQ(b.address(0xF003), fault.word2) << n;
    EXPECT_EQ(b.address(0xF004), fault.word3) << n;
    for (const ControlBit bit : {ControlBit::NNN, ControlBit::RUFBST, ControlBit::STS,
                                 ControlBit::STP, ControlBit::LPTP, ControlBit::QVZNIN})
      EXPECT_EQ(b.control(bit), bit == fault.control) << n;
    EXPECT_TRUE(b.control(ControlBit::UAFEHL) && b.control(ControlBit::STOZUS)) << n;
    const Causes& causes = b.plc().operatingSystem().record().picture().interrupt.causes;
    EXPECT_EQ(causes, Causes(fault.cause)) << n;
    EXPECT_EQ(b.plc().stoppedByFault(), fault.alarm != Alarm::Sts && fault.alarm != Alarm::Stp);
  }
}

// S5-BLK-05, S5-BLK-07, S5-ERR-17: what no row of the table begins, among it the call of an OB.
TEST(Alarms, IllegalCode) {
  for (const unsigned code : {0x6D14u, 0x4D14u, 0x600Du, 0x6009u}) {
    ListingBench b(kEmpty);
    b.options.program[{BlockType::Ob, 1}].words = {static_cast<std::uint16_t>(code), 0x6500};
    b.run(10);
    EXPECT_TRUE(b.stopped(Alarm::IllegalCode)) << code;
    EXPECT_EQ(b.address(0xF002), code);
    EXPECT_TRUE(b.control(ControlBit::NNN));
  }
  ListingBench deep(chain(11));  // twelve levels with OB 1
  deep.run(100);
  EXPECT_EQ(deep.plc().mode(), Mode::Run);
}

// S5-ERR-13, S5-SYS-07: system commands where there is no memory; segments that may not be touched.
TEST(Alarms, SystemCommands) {
  struct Case {
    std::string body;
    Alarm alarm;
    ControlBit bit;
    unsigned word2, word3;
  };
  const auto address = [](const char* flags, const char* segment, const char* offset) {
    return std::string(" L KB ") + segment + "\n T MW 10" + flags[0] + "\n L KH " + offset +
           "\n T MW 10" + flags[1] + "\n";
  };
  const auto akku = [&](const char* segment, const char* offset) {
    return address("02", segment, offset) + " L MD 100\n";
  };
  const auto both = [&](const char* source, const char* offset, const char* target) {
    return address("02", source, offset) + address("46", target, "0000") + " L MD 100\n L MD 104\n";
  };
  for (const Case& c :
       {Case{akku("6", "7000") + " LIR 0\n", Alarm::NoAnswerLirTir, ControlBit::LIRTIR, 0x7000, 6},
        Case{both("6", "7000", "1") + " TNB 1\n", Alarm::NoAnswerBlockTransfer, ControlBit::TBWFEH,
             0x7000, 6},
        Case{akku("7", "0000") + " TIR 2\n", Alarm::SegmentLirTir, ControlBit::NONE, 0, 0x0007},
        Case{akku("11", "0000") + " LIR 0\n", Alarm::SegmentLirTir, ControlBit::NONE, 0, 0x0011},
        Case{both("1", "0000", "8") + " TNW 1\n", Alarm::SegmentBlockTransfer, ControlBit::NONE, 0,
             0x0008}}) {
    ListingBench b(inFb(c.body));
    b.set(2003, 4);
    b.run(10);
    EXPECT_TRUE(b.stopped(c.alarm)) << c.body << b.plc().stopReason();
    EXPECT_TRUE(c.bit == ControlBit::NONE || b.control(c.bit)) << c.body;
    EXPECT_EQ(b.address(0xF003), c.word2);
    EXPECT_EQ(b.address(0xF004), c.word3);
  }
}

// S5-ERR-13: substitution of a periphery byte that does not answer: xxx2 is what was substituted.
TEST(Alarms, SubstitutionWithoutAnswer) {
  ListingBench b(R"(OB 1
 SPA FB 1
NAME : PRUEF
EIN  : PB 100
 BE
FB 1
NAME : PRUEF
BEZ  : EIN  E/A/D/B/T/Z: E   BI/BY/W/D: BY
 L =EIN
 BE
)");
  b.run(10);
  EXPECT_TRUE(b.stopped(Alarm::NoAnswerSubstitution)) << b.plc().stopReason();
  EXPECT_EQ(b.address(0xF003), 0x7264u);
  EXPECT_EQ(b.address(0xF004), 0x0100u);
  EXPECT_TRUE(b.control(ControlBit::QVZNIN));
}

// A step counter behind the memory finds none that answers.
TEST(Alarms, NoProgramMemory) {
  ListingBench b(kEmpty);
  b.options.program[{BlockType::Ob, 1}].words = {0x2DFF, 0x6500};  // to before the segment
  b.run(10);
  EXPECT_EQ(b.plc().mode(), Mode::Stop);
}

// S5-ERR-09: two levels; a third finds no room.
TEST(Alarms, InterruptStack) {
  ListingBench b("OB 1\n" + burn(8) + " BE\nOB 2\n BE\n");
  b.run(58);
  b.plc().advanceTo(ms(61));
  auto& levels = b.plc().machine().levels;
  ASSERT_EQ(levels.size(), 1u);
  levels.insert(levels.begin(), levels.front());  // as if one were interrupted already
  b.write("EB 7", 1);
  b.plc().advanceTo(ms(66));
  EXPECT_TRUE(b.stopped(Alarm::InterruptStack)) << b.plc().stopReason();
  EXPECT_TRUE(b.plc().operatingSystem().record().picture().interrupt.causes.test(Cause::STUEU));
}

struct StartCase {
  Alarm alarm;
  void (*prepare)(ListingBench&);
  ControlBit control;
};

const StartCase kStartCases[] = {
    {Alarm::MissingConverter,
     [](ListingBench& b) {
       b.options.surroundings.modules.push_back({.first = 70 - 7, .fitted = false});
     },
     ControlBit::EAADFE},
    {Alarm::MemoryGap, [](ListingBench& b) { b.options.surroundings.memoryGap = true; },
     ControlBit::ASPLUE},
    {Alarm::MemoryGap, [](ListingBench& b) { b.options.surroundings.dataMemoryFitted = false; },
     ControlBit::KEINPS},
    {Alarm::InputsTwice,
     [](ListingBench& b) {
       b.options.surroundings.modules = {{.first = 2, .bytes = 4}, {.first = 4, .bytes = 4}};
     },
     ControlBit::EAADFE},
    {Alarm::OutputsTwice,
     [](ListingBench& b) {
       b.options.surroundings.modules = {{.output = true, .first = 4},
                                         {.output = true, .first = 4}};
     },
     ControlBit::EAADFE},
    {Alarm::AlarmByteMissing,
     [](ListingBench& b) {
       b.options.program[{BlockType::Ob, 2}] = b.options.program[{BlockType::Ob, 1}];
       b.options.program[{BlockType::Ob, 2}].id.number = 2;
       b.options.surroundings.modules = {{.first = 0, .bytes = 7}};
     },
     ControlBit::EAADFE},
    {Alarm::PeripheryAssignment,
     [](ListingBench& b) { b.options.surroundings.modules = {{.first = 62, .bytes = 4}}; },
     ControlBit::EAADFE},
    {Alarm::BasicSynchronisation,
     [](ListingBench& b) { b.options.surroundings.basicProgram = EpromFault::Synchronisation; },
     ControlBit::SYNFEH},
    {Alarm::BasicBlock,
     [](ListingBench& b) { b.options.surroundings.basicProgram = EpromFault::Block; },
     ControlBit::KOPFNI},
    {Alarm::BasicChecksum,
     [](ListingBench& b) { b.options.surroundings.basicProgram = EpromFault::Checksum; },
     ControlBit::SUMF},
    {Alarm::DecodingDbMissing, [](ListingBench& b) { b.options.decodingDb = {.number = 99}; },
     ControlBit::NONE},
    {Alarm::DecodingDbLength, [](ListingBench& b) { b.options.decodingDb = {.number = 10}; },
     ControlBit::NONE},
    {Alarm::DecodingUnits,
     [](ListingBench& b) { b.options.decodingDb = {.number = 12, .units = 0}; }, ControlBit::NONE},
    {Alarm::DecodingDbShort,
     [](ListingBench& b) { b.options.decodingDb = {.number = 12, .units = 3}; }, ControlBit::NONE}};

// S5-ERR-07, S5-ERR-17, S5-ERR-19, S5-MEM-10: what stops the start-up.
TEST(Alarms, FaultsOfTheStartUp) {
  const std::string twelve = "DB 12\n" + [] {
    std::string text;
    for (int i = 0; i < 12; ++i) text += std::to_string(i) + ": KH = 0000\n";
    return text;
  }();
  for (const StartCase& c : kStartCases) {
    ListingBench b(std::string(kEmpty) + "DB 10\n0: KH = 0000\n" + twelve);
    if (c.alarm == Alarm::MissingConverter) b.options.surroundings.modules.clear();
    c.prepare(b);
    b.run(10);
    EXPECT_TRUE(b.stopped(c.alarm)) << number(c.alarm) << " but " << b.plc().stopReason();
    EXPECT_TRUE(c.control == ControlBit::NONE || b.control(c.control)) << number(c.alarm);
    EXPECT_TRUE(b.control(ControlBit::MAFEHL)) << number(c.alarm);
    EXPECT_FALSE(b.control(ControlBit::UAFEHL)) << number(c.alarm);
  }
}

// S5-BLK-21, S5-ERR-17: damaged memory, found by the next start.
TEST(Alarms, DamagedMemory) {
  struct Case {
    bool data;
    unsigned word, value;  // of the first block's header
    Alarm alarm;
    ControlBit bit;
  };
  for (const Case& c : {Case{false, 0, 0x1234, Alarm::ProgramSynchronisation, ControlBit::SYNFEH},
                        Case{true, 0, 0x1234, Alarm::DataSynchronisation, ControlBit::SYNFEH},
                        Case{false, 1, 0xFF01, Alarm::ProgramBlock, ControlBit::KOPFNI},
                        Case{true, 1, 0xFF01, Alarm::DataBlock, ControlBit::KOPFNI},
                        Case{false, 4, 0x0002, Alarm::ProgramBlock, ControlBit::SYNFEH},
                        Case{false, 5, 0xFFFF, Alarm::ProgramChecksum, ControlBit::SUMF}}) {
    ListingBench b(std::string(kEmpty) + "DB 10\n0: KH = 0000\n");
    b.run(70);
    b.plc().stop();
    BlockMemory& blocks = b.plc().machine().blocks;
    (c.data ? blocks.data() : blocks.program())[c.word] = static_cast<std::uint16_t>(c.value);
    EXPECT_FALSE(b.plc().coldStart());
    EXPECT_TRUE(b.stopped(c.alarm)) << number(c.alarm) << " but " << b.plc().stopReason();
    EXPECT_TRUE(b.control(c.bit)) << number(c.alarm);
  }
}

// S5-ERR-01, S5-ERR-02, S5-ERR-12, S5-ERR-17: conditions around the PLC, as a message or with STOP.
TEST(Alarms, ConditionsAroundThePlc) {
  struct Case {
    Alarm alarm;
    void (*begin)(Surroundings&);
    bool canStop;
    unsigned faults;  // DB 1 DW 8
  };
  for (const Case& c :
       {Case{Alarm::Jumpers, [](Surroundings& s) { s.jumpersRight = false; }, false, 0},
        Case{Alarm::MasterPlc, [](Surroundings& s) { s.masterPlcRuns = false; }, false, 0x0800},
        Case{Alarm::UnitSilent, [](Surroundings& s) { s.unit.answers = false; }, true, 0x0001},
        Case{Alarm::UnitTransmission, [](Surroundings& s) { s.unit.transmission = false; }, true,
             2},
        Case{Alarm::UnitTemperature, [](Surroundings& s) { s.unit.overTemperature = true; }, false,
             0x0004},
        Case{Alarm::UnitChanged, [](Surroundings& s) { s.unit.changed = true; }, true, 0x0008}})
    for (const bool stop : {false, true}) {
      ListingBench b(kEmpty);
      b.set(2002, 4);
      b.set(2003, 2, stop);
      b.run(70);
      c.begin(b.plc().surroundings());
      b.runTo(140);
      EXPECT_TRUE(b.pending(number(c.alarm))) << number(c.alarm);
      EXPECT_EQ(b.plc().mode() == Mode::Stop, stop && c.canStop) << number(c.alarm);
      EXPECT_EQ(b.shownAlarm(), number(c.alarm));
      EXPECT_EQ(b.address(0xF000), stop && c.canStop ? number(c.alarm) - 6000 : 0u);
      if (b.plc().mode() == Mode::Stop) continue;
      EXPECT_EQ(b.value("DB1.DW 8"), c.faults) << number(c.alarm);
      EXPECT_TRUE(b.plc().acknowledge(number(c.alarm)));
    }
}

// S5-ERR-07: mains failure of the distributed unit.
TEST(Alarms, MainsFailureOfTheUnit) {
  ListingBench b(kEmpty);
  b.set(2002, 4);
  b.set(2003, 2);
  b.run(70);
  b.plc().surroundings().unit.mains = false;
  b.runTo(140);
  EXPECT_TRUE(b.stopped(Alarm::UnitSilent));
  EXPECT_TRUE(b.control(ControlBit::NAUAS) && b.control(ControlBit::PERUNKL));
  EXPECT_TRUE(b.plc().operatingSystem().record().picture().interrupt.causes.test(Cause::NAU));
}

// S5-ERR-17: a module that stops to answer.
TEST(Alarms, ModuleFallsOut) {
  ListingBench b(kEmpty);
  b.run(70);
  b.plc().surroundings().modules[1].fitted = false;
  b.runTo(140);
  EXPECT_TRUE(b.stopped(Alarm::NoAnswerTransfer));
  EXPECT_EQ(b.address(0xF003), 0x000Au);
}

// S5-ERR-17, S5-ERR-18: the table is complete, and each alarm reacts as it says; hardware that the
// model has not is raised from outside.
TEST(Alarms, EachRowReacts) {
  EXPECT_EQ(alarmRows().size(), 59u);
  unsigned before = 0;
  for (const AlarmRow& r : alarmRows()) {
    EXPECT_GT(number(r.alarm), before);
    before = number(r.alarm);
    for (const bool stop : {false, true}) {
      ListingBench b(kEmpty);
      for (unsigned bit = 0; bit < 3; ++bit) b.set(2003, bit, stop);
      b.run(70);
      b.plc().raise({r.alarm, {1, 2, 3}});
      const bool stops = r.reaction == Reaction::Stop || (r.reaction != Reaction::Message && stop);
      EXPECT_EQ(b.plc().mode() == Mode::Stop, stops) << before;
      EXPECT_TRUE(b.pending(before));
      EXPECT_EQ(b.pending(kPlcStop), stops);
      EXPECT_EQ(b.shownAlarm(), before);
      EXPECT_EQ(b.address(0xF000), stops ? before - 6000 : 0u);
      EXPECT_TRUE(r.control == ControlBit::NONE || !stops || b.control(r.control));
      EXPECT_FALSE(b.plc().surroundings().nc.machiningStop);  // no interlock of the NC
    }
  }
}

// S5-ERR-17: user alarms and messages by their bits; they wait in the order of time.
TEST(Alarms, UserAlarms) {
  ListingBench b(std::string(kEmpty) +
                 "DB 20\n0: KH = 0000\n1: KH = 0000\n2: KH = 0000\n3: KH = 0000\n");
  b.options.userAlarms = {.alarms = BitField{.first = 100},
                          .messages = BitField{.db = 20, .first = 0},
                          .texts = {{6003, "Schutztür offen"}}};
  b.run(10);
  b.write("M 100.3", 1);
  b.runTo(70);
  b.write("DB20.D 3.15", 1);
  b.write("M 107.7", 1);
  b.runTo(130);
  const auto shown = b.plc().alarms();
  ASSERT_EQ(shown.size(), 3u);
  EXPECT_EQ(shown[0].text, "6003 Schutztür offen");
  EXPECT_EQ(shown[1].number, 6063u);
  EXPECT_EQ(shown[2].number, 7063u);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  b.write("M 100.3", 0);
  b.runTo(190);
  EXPECT_FALSE(b.pending(6003));
}

// S5-ERR-04, S5-ERR-05, S5-PG-04: alarm 3 on top; only a start without the cause clears it.
TEST(Alarms, AlarmListOfAStop) {
  ListingBench b("OB 1\n U E 0.0\n SPB PB 1\n BE\nPB 1\n STP\n BE\n");
  b.options.userAlarms.alarms = BitField{.first = 100};
  b.run(70);
  b.write("M 100.0", 1);
  b.runTo(130);
  b.write("E 0.0", 1);
  b.runTo(200);
  ASSERT_TRUE(b.stopped(Alarm::Stp));
  auto shown = b.plc().alarms();
  ASSERT_EQ(shown.size(), 3u);
  EXPECT_EQ(shown[0].text, "3 PLC-Stop");
  EXPECT_EQ(shown[1].number, 6000u);
  EXPECT_EQ(shown[2].number, 6112u);
  EXPECT_FALSE(b.plc().acknowledge(6112));
  EXPECT_FALSE(b.plc().acknowledge(kPlcStop));
  EXPECT_TRUE(b.plc().programmer().start());
  b.runTo(300);
  EXPECT_TRUE(b.stopped(Alarm::Stp));  // the cause is still there
  b.write("E 0.0", 0);
  EXPECT_TRUE(b.plc().programmer().start());
  b.runTo(400);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  EXPECT_FALSE(b.pending(kPlcStop));
}

}  // namespace
}  // namespace merker::sinumerik
