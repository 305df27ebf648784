// What the start information of all organization blocks has in common.
#include <gtest/gtest.h>

#include "cpu/cpu.h"
#include "cpu/trigger.h"
#include "program.h"

namespace merker::station::test {
namespace {

// Keeps bytes 0..3 in MD at, the time of the request in MD at+4 and MD at+8.
std::string keeping(int number, int at) {
  const auto flags = [&](int offset) { return "T MD " + std::to_string(at + offset) + "; "; };
  return ob(number, "L LD 0; " + flags(0) + "L LD 12; " + flags(4) + "L LD 16; " + flags(8));
}

struct Row {
  int ob;
  unsigned priority;
  int at;
};
// The priority classes of an S7-300; those of the error OBs in the cycle.
const Row kCyclic[] = {{1, 1, 0}, {35, 12, 20}, {100, 27, 40}};
const Row kTriggered[] = {{40, 16, 60},  {80, 26, 80},  {82, 26, 100}, {83, 26, 120},
                          {84, 26, 140}, {85, 26, 160}, {86, 26, 180}, {87, 26, 200}};

// S7-OBI-01: priority, number, and a DATE_AND_TIME of 1990-01-01 (the clock of a new CPU).
void expectCommon(Plc& plc, const Row& row) {
  const std::uint32_t head = plc.read("MD " + std::to_string(row.at));
  EXPECT_EQ(head >> 8 & 0xFF, row.priority) << "OB " << row.ob;
  EXPECT_EQ(head & 0xFF, static_cast<unsigned>(row.ob)) << "OB " << row.ob;
  EXPECT_EQ(plc.read("MD " + std::to_string(row.at + 4)) >> 8, 0x900101u) << "OB " << row.ob;
  EXPECT_EQ(plc.read("MD " + std::to_string(row.at + 8)) & 0xF, 2u) << "Monday, OB " << row.ob;
}

TEST(StartInformation, OfAllBlocks) {
  std::string awl;
  for (const Row& row : kCyclic) awl += keeping(row.ob, row.at);
  for (const Row& row : kTriggered) awl += keeping(row.ob, row.at);
  Plc plc(awl, *findCpuModel("generic"));
  plc.start();
  plc.run(Duration::milliseconds(250));
  for (const Row& row : kTriggered) {
    cpu::trigger(plc->cpu(), {.ob = static_cast<std::uint8_t>(row.ob), .address = 256});
    plc->advanceCycles(2);
  }
  for (const Row& row : kCyclic) expectCommon(plc, row);
  for (const Row& row : kTriggered) expectCommon(plc, row);
}

// S7-OBI-01: the time is that of the request, not that of the call; OB 35 asks at 100 ms and waits
// for nothing, OB 1 of the second cycle begins later than that of the first.
TEST(StartInformation, TimeIsThatOfTheRequest) {
  Plc plc(keeping(35, 0) + keeping(1, 20));
  plc.start();
  plc.run(Duration::milliseconds(150));
  const auto seconds = plc.read("MB 9"), milliseconds = plc.read("MW 10") >> 4;
  EXPECT_EQ(seconds, 0u);
  EXPECT_EQ(milliseconds >> 8, 1u) << "100 to 199 ms behind the start, BCD";
  EXPECT_GT(plc.read("MD 28"), plc.read("MD 8"));
}

}  // namespace
}  // namespace merker::station::test
