// FB 190 K-LEITPC between two PLCs.
#include "rig.h"

namespace merker::nc {
namespace {

std::string call(const std::string& place, const std::string& order,
                 const char* message = "AB 20") {
  return ":SPA FB 190\nNAME :K-LEITPC\nADPR : KF 0\nDBDW : KY " + place + "\nR/A : KY " + order +
         "\nMELD : " + message + "\n";
}

struct Pair {
  Pair(const std::string& control, const std::string& master) {
    controlSide.macros.couple(area, Side::Control);
    masterSide.macros.couple(area, Side::Master);
    EXPECT_TRUE(controlSide.start(dataBlock(33, 50) + "OB 1\n" + control + ":BE\n"));
    EXPECT_TRUE(masterSide.start(dataBlock(45, 50) + "OB 1\n" + master + ":BE\n"));
  }
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; i += 10) {
      controlSide.milliseconds(10);
      masterSide.milliseconds(10);
    }
  }
  std::shared_ptr<CouplingArea> area = std::make_shared<CouplingArea>();
  Rig controlSide, masterSide;
};

// S5-FM-50, S5-FM-51, S5-FM-53: block I of DB 33 to DB 45, block II back.
TEST(Coupling, TwoBlocksBetweenTwoPlcs) {
  Pair pair(call("33,1", "0,10") + call("33,20", "1,5", "AB 21"),
            call("45,1", "1,10") + call("45,20", "0,5", "AB 21"));
  for (unsigned i = 0; i < 50; ++i) {
    pair.controlSide.word(33, i) = static_cast<std::uint16_t>(1000 + i);
    pair.masterSide.word(45, i) = static_cast<std::uint16_t>(2000 + i);
  }
  pair.run(300);
  for (unsigned i = 0; i < 50; ++i) {
    EXPECT_EQ(pair.masterSide.word(45, i), (i >= 1 && i <= 10 ? 1000 : 2000) + i);
    EXPECT_EQ(pair.controlSide.word(33, i), (i >= 20 && i <= 24 ? 2000 : 1000) + i);
  }
  for (Rig* const rig : {&pair.controlSide, &pair.masterSide}) {
    EXPECT_EQ(rig->machine().outputs[20], 255u);
    EXPECT_EQ(rig->machine().outputs[21], 255u);
  }
}

unsigned message(const std::string& place, const std::string& order, bool faulty = false) {
  Rig rig;
  auto area = std::make_shared<CouplingArea>();
  area->faulty = faulty;
  rig.macros.couple(area, Side::Control);
  rig.options.dataInEprom.set(34);
  EXPECT_TRUE(
      rig.start(dataBlock(33, 50) + dataBlock(34, 150) + "OB 1\n" + call(place, order) + ":BE\n"));
  rig.cycles(1);
  EXPECT_FALSE(rig.stopped());
  return rig.machine().outputs[20];
}

// S5-FM-50: words 0 and 127 of the area belong to nobody; 1 to 126 are the user's, whole.
TEST(Coupling, WordsOfTheUser) {
  for (const char* const place : {"34,0", "34,127"})
    for (const char* const direction : {"0,1", "1,1"}) EXPECT_EQ(message(place, direction), 5u);
  Pair pair(call("33,1", "0,126"), call("45,1", "1,126"));
  pair.run(20);
  EXPECT_EQ(pair.controlSide.machine().outputs[20], 3u);  // 50 words are too few
  pair.area->words[0] = pair.area->words[127] = 0xAAAA;
  Rig rig;
  rig.macros.couple(pair.area, Side::Control);
  ASSERT_TRUE(rig.start(dataBlock(33, 128) + "OB 1\n" + call("33,1", "0,126") + ":BE\n"));
  for (unsigned i = 0; i < 128; ++i) rig.word(33, i) = static_cast<std::uint16_t>(i);
  rig.cycles(1);
  EXPECT_EQ(rig.machine().outputs[20], 255u);
  for (unsigned i = 0; i < 128; ++i)
    EXPECT_EQ(pair.area->words.at(i), i == 0 || i == 127 ? 0xAAAAu : i);
}

// S5-FM-52: the coupling memory itself does not answer: 6151.
TEST(Coupling, MemoryThatDoesNotAnswer) {
  Rig rig;
  auto area = std::make_shared<CouplingArea>();
  area->silent = true;
  rig.macros.couple(area, Side::Control);
  ASSERT_TRUE(rig.start(dataBlock(33, 50) + "OB 1\n" + call("33,1", "0,10") + ":BE\n"));
  rig.cycles(1);
  EXPECT_EQ(rig.stop(), "6151");
}

// S5-FM-52, S5-FM-05: messages, never a STOP.
TEST(Coupling, Messages) {
  EXPECT_EQ(message("33,1", "0,10"), 255u);
  EXPECT_EQ(message("33,1", "0,10", true), 1u);
  EXPECT_EQ(message("35,1", "0,10"), 2u);
  EXPECT_EQ(message("33,45", "0,5"), 255u);
  EXPECT_EQ(message("33,46", "0,5"), 3u);
  EXPECT_EQ(message("34,1", "1,10"), 4u);
  EXPECT_EQ(message("34,1", "0,10"), 255u);
  EXPECT_EQ(message("33,0", "0,10"), 5u);
  EXPECT_EQ(message("34,1", "0,126"), 255u);
  EXPECT_EQ(message("34,1", "0,127"), 5u);
  EXPECT_EQ(message("34,126", "0,1"), 255u);
  EXPECT_EQ(message("34,127", "0,1"), 5u);
  EXPECT_EQ(message("33,1", "0,0"), 5u);
  EXPECT_EQ(message("33,1", "2,10"), 6u);
}

// S5-FM-52: nobody is connected.
TEST(Coupling, NoPartner) {
  Rig rig;
  ASSERT_TRUE(rig.start(dataBlock(33, 50) + "OB 1\n" + call("33,1", "0,10", "MB 150") + ":BE\n"));
  rig.cycles(1);
  EXPECT_EQ(rig.machine().flags[150], 1u);
}

// S5-FM-54: alarm 6163 is a message; D 8.11 and M 8.0 tell the program.
TEST(Coupling, MasterFails) {
  Pair pair(call("33,1", "0,10"), call("45,1", "1,10"));
  pair.run(300);
  EXPECT_EQ(pair.controlSide.word(1, 8) & 0x0800, 0);
  pair.masterSide.plc->stop();
  pair.run(300);
  EXPECT_FALSE(pair.controlSide.stopped());
  EXPECT_EQ(pair.controlSide.word(1, 8) & 0x0800, 0x0800);
  EXPECT_EQ(pair.controlSide.machine().flags[8] & 1, 1);
  EXPECT_EQ(pair.controlSide.plc->operatingSystem().record().fineCode().number, 0x6163);
}

}  // namespace
}  // namespace merker::nc
