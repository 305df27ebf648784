// Commands of a partner with RK 512 (PTP-VEC-53 to -59).
#include "links.h"

namespace merker::serial {
namespace {

// BCC of a block: text of its bytes to the whole block on the line.
std::string block(std::string_view bytes) {
  std::uint8_t check = 0x13;
  Bytes doubled;
  for (const std::uint8_t byte : hex(bytes)) {
    doubled.push_back(byte);
    check ^= byte;
    if (byte != 0x10) continue;
    doubled.push_back(byte);
    check ^= byte;
  }
  return text(doubled) + " 10 03 " + text({check});
}

// The answer to a command, and the events at SERVE_RK.
std::string serves(LinkedScript& s, std::string_view command, std::string_view reaction) {
  s.commands(block(command), block(reaction));
  s.run(300);
  EXPECT_TRUE(s.partner.done()) << command;
  std::string events = s.cpu.events();
  s.cpu.outcomes.clear();
  return events;
}

std::string once(std::string_view command, std::string_view reaction) {
  LinkedScript s;
  s.cpu.memory.db(10) = hex("01 02 03 04 05 06 07 08");
  s.cpu.memory.area('E') = counting(16);
  s.cpu.memory.area('A') = counting(16);
  s.cpu.memory.area('T') = hex("20 10 00 99 12 34");
  s.cpu.memory.area('Z') = hex("00 25 01 00");
  s.run(1);
  return serves(s, command, reaction);
}

// PTP-VEC-53, PTP-VEC-54, PTP-VEC-55, PTP-VEC-56, PTP-VEC-57, PTP-VEC-59, PTP-RK512-40, PTP-ERR-12,
// PTP-ERR-13 PTP-ERR-15, PTP-ERR-18, PTP-ERR-19, PTP-RK512-48, PTP-RK512-49, PTP-RK512-52,
// PTP-RK512-55
TEST(LinkPassive, ErrorsInTheHeader) {
  EXPECT_EQ(block("55 00 41 44 0A 00 00 01 FF 1F 11 22"),
            "55 00 41 44 0A 00 00 01 FF 1F 11 22 10 03 9B");
  EXPECT_EQ(once("55 00 41 44 0A 00 00 01 FF 1F 11 22", "00 00 00 10"), "0601");
  EXPECT_EQ(once("00 00 53 44 0A 00 00 01 FF 1F 11 22", "00 00 00 16"), "0602");
  EXPECT_EQ(once("00 00 41 51 0A 00 00 01 FF 1F 11 22", "00 00 00 10"), "0604");
  EXPECT_EQ(once("00 00 41 44 0A 00 00 01 64 1E 11 22", "00 00 00 0C"), "0609");
  EXPECT_EQ(once("00 00 41 44 0A 00 00 01 FF 5F 11 22", "00 00 00 0C"), "060A");
  EXPECT_EQ(once("00 00 41 44 0A 00 00 03 FF 1F 11 22 33 44", "00 00 00 34"), "0611");
}

// PTP-RK512-40: bytes 5 and 6 go before what is behind them
TEST(LinkPassive, TheFirstErrorInTheOrderOfTheBytes) {
  EXPECT_EQ(once("00 00 45 4D 01 00 00 01 64 18", "00 00 00 0C"), "0607");
  EXPECT_EQ(once("00 00 45 5A 01 CB B1 D3 FF 1F", "00 00 00 0C"), "0607");
  EXPECT_EQ(once("00 00 41 44 63 00 00 01 FF 5F 11 22", "00 00 00 14"), "0301");
  EXPECT_EQ(once("00 00 41 44 0A 04 00 00 FF 5F", "00 00 00 14"), "0301");
  EXPECT_EQ(once("00 00 41 44 0A 00 00 09 FF 5F 11 22", "00 00 00 34"), "0611");
  EXPECT_EQ(once("00 00 41 44 00 00 00 01 FF 5F 11 22", "00 00 00 14"), "0606");
}

// PTP-RK512-40: without SERVE_RK nobody knows the areas
TEST(LinkPassive, HeaderErrorsWithoutService) {
  LinkedScript s;
  s.cpu.serves = false;
  EXPECT_EQ(serves(s, "00 00 41 44 63 00 00 01 FF 5F 11 22", "00 00 00 0C"), "060A");
}

// PTP-ERR-02
TEST(LinkPassive, WriteProtectedBlock) {
  LinkedScript s;
  s.cpu.memory.db(10).resize(8);
  s.cpu.memory.locked = {10};
  s.run(1);
  EXPECT_EQ(serves(s, "00 00 41 44 0A 00 00 01 FF 1F 11 22", "00 00 00 14"), "0303");
  EXPECT_EQ(s.cpu.memory.db(10), Bytes(8));
  EXPECT_EQ(serves(s, "00 00 45 44 0A 00 00 01 FF 1F", "00 00 00 00 00 00"), "0000");
}

// PTP-RK512-44, PTP-ERR-01: deleted, or made read-only, between two telegrams
TEST(LinkPassive, BlockThatGoesBetweenTelegrams) {
  for (const bool locked : {true, false}) {
    LinkedScript s;
    s.cpu.memory.db(10).resize(200);
    s.run(1);
    const std::string data = text(Bytes(128, 0x41)), rest = text(Bytes(2, 0x42));
    EXPECT_EQ(serves(s, "00 00 41 44 0A 00 00 41 FF 1F " + data, "00 00 00 00"), "");
    if (locked)
      s.cpu.memory.locked = {10};
    else
      s.cpu.memory.bytes.erase({'D', 10});
    EXPECT_EQ(serves(s, "FF 00 41 44 " + rest, "FF 00 00 14"), locked ? "0303" : "0301");
  }
}

// PTP-RK512-40, PTP-OPEN-15
TEST(LinkPassive, WrongLengths) {
  EXPECT_EQ(once("00 00 41 44 0A 00", "00 00 00 34"), "0610");
  EXPECT_EQ(once("FF 00 41", "FF 00 00 34"), "0610");
  EXPECT_EQ(once("00 00 45 44 0A 00 00 01 FF 1F 11 22", "00 00 00 34"), "0611");
  EXPECT_EQ(once("00 00 45 44 0A 00 00 00 FF 1F", "00 00 00 34"), "0611");
  EXPECT_EQ(once("00 00 45 44 0A 00 02 01 FF 1F", "00 00 00 34"), "0611");
}

// PTP-VEC-58, PTP-RK512-44, PTP-ERR-20
TEST(LinkPassive, FollowOnWithoutAFirst) {
  EXPECT_EQ(once("FF 00 41 44 11 22", "FF 00 00 36"), "060E");
}

// PTP-RK512-23, PTP-RK512-42, SFB65-04, SFB65-05
TEST(LinkPassive, StoresAndReports) {
  LinkedScript s;
  s.cpu.memory.db(10).resize(8);
  s.run(1);
  s.commands(block("00 00 41 44 0A 01 00 02 FF 1F 11 22 33 44"), block("00 00 00 00"));
  s.run(20);  // the command is being received
  EXPECT_EQ(s.cpu.memory.db(10), Bytes(8));
  s.run(300);
  EXPECT_EQ(text(s.cpu.memory.db(10)), "00 00 11 22 33 44 00 00");
  ASSERT_EQ(s.cpu.outcomes.size(), 1U);
  const LinkJob& job = s.cpu.outcomes[0].job;
  EXPECT_EQ(number(s.cpu.outcomes[0].event), "0000");
  EXPECT_EQ(job.type, 'D');
  EXPECT_EQ(job.block, 10);
  EXPECT_EQ(job.offset, 2);
  EXPECT_EQ(job.length, 4);
  EXPECT_FALSE(job.flag.used());
}

// PTP-RK512-20, SFB65-02, SFB65-11, PTP-RK512-19
TEST(LinkPassive, ProvidesEachType) {
  EXPECT_EQ(once("00 00 45 44 0A 01 00 02 FF 1F", "00 00 00 00 03 04 05 06"), "0000");
  EXPECT_EQ(once("00 00 45 4D 00 64 00 03 FF 1F", "00 00 00 00 00 00 00"), "0000");
  EXPECT_EQ(once("00 00 45 45 00 03 00 02 FF 1F", "00 00 00 00 03 04"), "0000");
  EXPECT_EQ(once("00 00 45 41 00 05 00 01 FF 1F", "00 00 00 00 05"), "0000");
  EXPECT_EQ(once("00 00 45 54 00 01 00 02 FF 1F", "00 00 00 00 00 99 12 34"), "0000");
  EXPECT_EQ(once("00 00 45 5A 00 00 00 01 FF 1F", "00 00 00 00 00 25"), "0000");
}

// PTP-OPEN-14, PTP-ERR-01, PTP-ERR-16, PTP-ERR-17, SFB65-07, SFB65-09, PTP-RK512-51,
// PTP-RK512-48
TEST(LinkPassive, AreasThatDoNotExist) {
  EXPECT_EQ(once("00 00 41 44 00 00 00 01 FF 1F 11 22", "00 00 00 14"), "0606");
  EXPECT_EQ(once("00 00 41 44 0B 00 00 01 FF 1F 11 22", "00 00 00 14"), "0301");
  EXPECT_EQ(once("00 00 41 44 0A 04 00 01 FF 1F 11 22", "00 00 00 14"), "0301");
  EXPECT_EQ(once("00 00 45 44 0A 03 00 02 FF 1F", "00 00 00 14"), "0301");
  EXPECT_EQ(once("00 00 45 4D 01 00 00 01 FF 1F", "00 00 00 0C"), "0607");
  EXPECT_EQ(once("00 00 45 4D 00 FF 00 02 FF 1F", "00 00 00 0C"), "0301");
  EXPECT_EQ(once("00 00 45 54 00 02 00 02 FF 1F", "00 00 00 0C"), "0301");
  EXPECT_EQ(once("00 00 45 5A 00 02 00 01 FF 1F", "00 00 00 0C"), "0607");
  EXPECT_EQ(once("00 00 4F 44 0A 00 00 01 FF 1F 11 22", "00 00 00 10"), "0604");
  EXPECT_EQ(once("00 00 45 58 0A 00 00 01 FF 1F", "00 00 00 10"), "0604");
  EXPECT_EQ(once("00 00 41 4D 0A 00 00 01 FF 1F 11 22", "00 00 00 10"), "0604");
}

// PTP-RK512-41, PTP-RK512-43, PTP-RK512-58, SFB65-08, PTP-ERR-21, PTP-RK512-54, PTP-OPEN-16
TEST(LinkPassive, CoordinationFlag) {
  LinkedScript s;
  s.cpu.memory.db(101).resize(8);
  s.run(1);
  const char* command = "00 00 41 44 65 00 00 01 64 16 11 22";
  EXPECT_EQ(serves(s, command, "00 00 00 00"), "0000");
  EXPECT_TRUE(s.cpu.memory.flag({100, 6}));
  s.cpu.memory.db(101)[0] = 0;
  EXPECT_EQ(serves(s, command, "00 00 00 32"), "060F");
  EXPECT_EQ(s.cpu.memory.db(101)[0], 0);
  s.cpu.memory.area('M')[100] = 0;
  EXPECT_EQ(serves(s, command, "00 00 00 00"), "0000");
  s.cpu.memory.area('M')[100] = 0;
  EXPECT_EQ(serves(s, "00 00 45 4D 00 64 00 01 64 16", "00 00 00 00 00"), "0000");
  EXPECT_TRUE(s.cpu.memory.flag({100, 6}));
}

// PTP-RK512-43
TEST(LinkPassive, FlagIsNotSetBeforeTheReactionIsAcknowledged) {
  LinkedScript s;
  s.cpu.memory.db(101).resize(8);
  s.run(1);
  s.partner.send("02").expect("10").send(hex(block("00 00 41 44 65 00 00 01 64 16 11 22")));
  s.partner.expect("10");
  s.run(20'000);  // it never takes the reaction
  EXPECT_EQ(s.cpu.events(), "0703");
  EXPECT_FALSE(s.cpu.memory.flag({100, 6}));
}

std::string first130(const char* letters) {
  return block(std::string("00 00 ") + letters + " 14 00 00 41 FF 1F " + text(Bytes(128, 0x55)));
}

// PTP-RK512-44, PTP-ERR-14, PTP-ERR-20
TEST(LinkPassive, WrongFollowOnTelegrams) {
  const std::tuple<const char*, const char*, const char*> rows[] = {
      {"FF 00 45 44", "FF 00 00 16", "0603"},
      {"FF 00 41 4D 11 22", "FF 00 00 10", "0604"},
      {"FF 00 41 44 11 22 33", "FF 00 00 34", "0611"},
      {"00 00 41 44 14 00 00 01 FF 1F 11 22", "00 00 00 36", "060E"},
      {"FF 00 41 44 11 22", "FF 00 00 00", "0000"}};
  for (const auto& [command, reaction, event] : rows) {
    LinkedScript s;
    s.cpu.memory.db(20).resize(200);
    s.run(1);
    s.commands(first130("41 44"), block("00 00 00 00"));
    s.run(400);
    EXPECT_EQ(s.cpu.events(), "");
    EXPECT_EQ(serves(s, command, reaction), event);
  }
}

// PTP-RK512-45
TEST(LinkPassive, NoFollowOnTelegram) {
  LinkedScript s;
  s.cpu.memory.db(20).resize(200);
  s.run(1);
  s.commands(first130("41 44"), block("00 00 00 00"));
  s.run(19'900);
  EXPECT_EQ(s.cpu.events(), "");
  s.run(500);
  EXPECT_EQ(s.cpu.events(), "060E");
}

// PTP-RK512-46, PTP-OPEN-13, PTP-RK512-47, PTP-RK512-53, SFB64-07
TEST(LinkPassive, CpuIsNotReady) {
  const char* command = "00 00 45 4D 00 64 00 01 FF 1F";
  LinkedScript never;
  never.cpu.serves = false;
  EXPECT_EQ(serves(never, command, "00 00 00 2A"), "");
  for (const bool stopped : {false, true}) {
    LinkedScript s;
    s.run(1);
    s.cpu.serves = false;
    if (stopped)
      s.cpu.driver.cpuStopped();
    else
      s.cpu.driver.disable(Event::Reset);
    EXPECT_EQ(serves(s, command, "00 00 00 0A"), "");
    s.cpu.driver.cpuStarted();
    s.cpu.serves = true;
    s.run(1);
    EXPECT_EQ(serves(s, command, "00 00 00 00 00"), "0000");
  }
}

// PTP-RK512-42, PTP-RK512-46
TEST(LinkPassive, WaitsForTheNextCall) {
  LinkedScript s;
  s.run(1);
  s.cpu.serves = false;
  s.commands(block("00 00 45 4D 00 64 00 01 FF 1F"), block("00 00 00 00 00"));
  s.run(10'000);
  EXPECT_FALSE(s.partner.done());
  s.cpu.serves = true;
  s.run(100);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.cpu.events(), "0000");
}

// SFB65-01
TEST(LinkPassive, EndOfEnableAbortsTheJob) {
  LinkedScript s;
  s.cpu.memory.db(20).resize(200);
  s.run(1);
  s.commands(first130("41 44"), block("00 00 00 00"));
  s.run(400);
  s.cpu.driver.disable(Event::Reset);
  s.run(1);
  EXPECT_EQ(s.cpu.events(), "051D");
}

// PTP-RK512-25, PTP-RK512-02
TEST(LinkPassive, FaultOfTheProcedureGivesNoReaction) {
  LinkedScript s;
  s.run(1);
  s.partner.send("02").expect("10").send("00 00 45 4D 00 64 00 01 FF 1F 10 03 00").expect("15");
  s.run(1'000);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.lines.seen.back().value, Procedure::kNak);
  EXPECT_EQ(s.cpu.events(), "0801");
}

// PTP-RK512-60
TEST(LinkPassive, WordsOfStep5AreTwoBytes) {
  const std::pair<const char*, std::uint16_t> rows[] = {{"0A", 20}, {"FF", 510}};
  for (const auto& [word, offset] : rows) {
    const Command command = read(hex(std::string("00 00 45 44 14 ") + word + " 00 01 FF 1F"));
    EXPECT_EQ(command.job.offset, offset);
  }
}

}  // namespace
}  // namespace merker::serial
