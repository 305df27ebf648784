// Block status and stacks of a programming device, beside what the workbench shows of them.
#include "served/block_task.h"

#include "s7comm/test_job.h"
#include "served/test_stacks.h"
#include "test_line.h"

namespace merker::served {
namespace {

constexpr unsigned kOldStatus = 0x01, kNewStatus = 0x13, kEnableJob = 0x0E;

// FC 1 is called by OB 1, and by FC 2 with DB 5 open.
constexpr std::string_view kCalls =
    "DATA_BLOCK DB 5\nSTRUCT\n a : DWORD := DW#16#01020304;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
    "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n L MB 10;\n + 1;\n T MB 10;\n U M 10.0;\n = M 20.0;\n"
    " SPBN end;\n L 77;\nend: NOP 0;\nEND_FUNCTION\n"
    "FUNCTION FC 2 : VOID\nBEGIN\nNETWORK\n AUF DB 5;\n L 1000;\n UC FC 1;\n NOP 0;\nEND_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L 5;\n LAR1 P#7.0;\n UC FC 1;\n UC FC 2;\n"
    "END_ORGANIZATION_BLOCK\n";

std::string word(std::uint32_t value) {
  Bytes octets;
  appendWord(octets, value);
  return toHex(octets) + ' ';
}

// Parameters of a block status: block, number, begin; a condition of the call.
std::string blockWords(unsigned type, unsigned number, std::string_view environment = {}) {
  const std::string event = environment.empty() ? "06 00 " : "06 01 ";
  return "00 00 00 01 00 00 00 FF 00 01 00 01 00 01 00 01 00 01 " + event + word(type) +
         word(number) + "00 00 00 40 " + std::string(environment);
}

std::string lines(const std::vector<std::uint32_t>& addresses, std::string_view mask) {
  std::string text = "80 " + word(static_cast<std::uint32_t>(addresses.size())).substr(3) + "00 " +
                     std::string(mask);
  for (const std::uint32_t address : addresses)
    text += ' ' + word(address) + "00 " + std::string(mask);
  return text;
}

class BlockStatus : public ::testing::Test {
 protected:
  BlockStatus() { plc.cycles(1); }

  std::vector<std::uint32_t> addresses(BlockId block) {
    std::vector<std::uint32_t> all;
    const auto code = plc.monitor().program().find(block);
    for (std::size_t i = 0; i < code->lineCount(); ++i) all.push_back(code->line(i).offset);
    return all;
  }
  // What is told at the next call, behind the type, function, number and error.
  std::string told(std::string_view job) {
    line.ask(kEnableJob, words(0, 1, 0), job);
    plc.cycles(2);
    const std::string heard = line.heard();
    return heard.substr(0, heard.find(" | "));
  }

  ServedPlc plc{"a.awl", std::string(kCalls)};
  TestLine line{plc};
};

// S7-EDIT-21: what is told is what the workbench shows.
TEST_F(BlockStatus, isThatOfTheWorkbench) {
  const BlockId block{BlockKind::FC, 2};
  ASSERT_TRUE(plc.monitor().debugger().addStatus(block));
  const auto all = addresses(block);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(line.ask(kNewStatus, blockWords(0x0C, 2), lines(all, "7F")), "answer 13 01 00 00");
  const std::string heard = told("13 01");
  Bytes expected = hex("00 00");
  const monitor::ProgramStatus& shown = *plc.monitor().debugger().status(block);
  for (const std::uint32_t address : all) {
    const monitor::StatusRow* const row = shown.at(address);
    ASSERT_NE(row, nullptr);
    Bytes one;
    appendWord(one, address);
    s7comm::appendRegisters(one, testRegisters(row->after), 0x7F);
    expected.insert(expected.end(), one.begin(), one.end());
  }
  // The accumulators go on counting: what is compared is told in the same cycle.
  EXPECT_TRUE(heard.starts_with("says 13 01 00 00: 00 00 ")) << heard;
  EXPECT_EQ(heard.size(),
            std::string("says 13 01 00 00: ").size() + 3 * (expected.size() + 24) - 1);
}

// FC 1 finds L 5 and LAR1; behind L MB 10 its value is in ACCU 1, behind + 1 one more.
TEST_F(BlockStatus, registersOfEachLine) {
  const auto all = addresses({BlockKind::FC, 1});
  line.ask(kNewStatus, blockWords(0x0C, 1), lines({all[0], all[1]}, "0E"));
  plc.writeNow(flags(10, 1), {6});
  EXPECT_EQ(told("13 01"),
            "says 13 01 00 00: 00 00 00 00 00 05 00 00 00 00 00 00 00 38 "
            "00 00 00 00 00 08 00 00 00 05 00 00 00 38 "
            "00 02 00 00 00 09 00 00 00 05 00 00 00 38");
}

// Every second call jumps over L 77.
TEST_F(BlockStatus, onlyWhatWasExecuted) {
  const auto all = addresses({BlockKind::FC, 1});
  const std::string byOb = "00 00 00 01 " + word(0x08) + word(1);
  const std::string byFc = "00 00 00 01 " + word(0x0C) + word(2);
  const std::string three = lines({all[5], all[6], all[7]}, "04");
  line.ask(kNewStatus, blockWords(0x0C, 1, byOb), three);
  line.ask(kNewStatus, blockWords(0x0C, 1, byFc), three);
  const std::size_t one = told("13 01").size(), other = told("13 02").size();
  EXPECT_EQ(std::max(one, other) - std::min(one, other), 18u);  // an address and ACCU 2
}

// Both data blocks of a call of FC 1: none, and DB 5.
TEST_F(BlockStatus, ofACallByThisBlockOrWithThisDataBlock) {
  const std::string byOb = "00 00 00 01 " + word(0x08) + word(1);
  const std::string byFc = "00 00 00 01 " + word(0x0C) + word(2);
  const std::string withDb = "00 02 0A 00 " + word(5) + word(0);
  const char* const kNone = "00 00 00 00 00 00";
  const char* const kDb5 = "0A 00 00 05 00 00";
  line.ask(kNewStatus, blockWords(0x0C, 1, byOb), "80 00 00 20");
  EXPECT_EQ(told("13 01"), std::string("says 13 01 00 00: 00 00 ") + kNone);
  line.ask(kNewStatus, blockWords(0x0C, 1, byFc), "80 00 00 20");
  EXPECT_EQ(told("13 03"), std::string("says 13 03 00 00: 00 00 ") + kDb5);
  line.ask(kNewStatus, blockWords(0x0C, 1, withDb), "80 00 00 20");
  EXPECT_EQ(told("13 05"), std::string("says 13 05 00 00: 00 00 ") + kDb5);
  line.ask(kNewStatus, blockWords(0x0C, 1, "00 02 0A 00 " + word(6) + word(0)), "80 00 00 20");
  EXPECT_EQ(told("13 07"), "");
}

// Two octets for each word of code; always with STW, both accumulators together.
TEST_F(BlockStatus, inItsOldForm) {
  const auto all = addresses({BlockKind::FC, 2});
  ASSERT_EQ(all[1], 2u);  // AUF DB 5 is one word, L 1000 two
  EXPECT_EQ(line.ask(kOldStatus, blockWords(0x0C, 2), "80 00 80 80 80 01 00 00"),
            "answer 01 01 00 00");
  const std::string heard = told("01 01");
  EXPECT_TRUE(heard.starts_with("says 01 01 00 00: 00 00 ")) << heard;
  EXPECT_TRUE(heard.find(" 00 02 ") != std::string::npos &&
              heard.find(" 00 00 03 E8 ") != std::string::npos)
      << heard;
}

TEST_F(BlockStatus, whatIsRefused) {
  EXPECT_EQ(line.ask(kNewStatus, blockWords(0x0C, 9), "80 00 00 01"), "answer 13 01 D0 11");
  EXPECT_EQ(line.ask(kNewStatus, blockWords(0x0C, 1), "80 02 00 01 00 00 00 01"),
            "answer 13 00 D0 33");
  EXPECT_EQ(line.ask(kNewStatus, blockWords(0x0C, 1), lines({0, 2, 0, 2, 0, 2, 0, 2, 0, 2}, "7F")),
            "answer 13 02 D0 64");
  line.ask(kNewStatus, blockWords(0x0C, 1), "80 00 00 01");
  EXPECT_EQ(line.ask(0x12, words(0, 1, 0),
                     "00 00 13 04 00 1C 00 04 " + blockWords(0x0C, 1) + "80 00 00 01"),
            "answer 12 04 D0 A8");
}

// Another version of the block: the lines of the old one that are none here are not told.
TEST_F(BlockStatus, linesBehindTheEnd) {
  EXPECT_EQ(line.ask(kNewStatus, blockWords(0x0C, 1), "80 01 00 01 40 00 00 01"),
            "answer 13 01 00 00");
  const std::string heard = told("13 01");
  EXPECT_TRUE(heard.starts_with("says 13 01 00 00: 00 00 ")) << heard;
  EXPECT_EQ(heard.find("40 00"), std::string::npos) << heard;
}

// Nothing of it is left in the CPU.
TEST_F(BlockStatus, endsWithItsJob) {
  line.ask(kNewStatus, blockWords(0x0C, 1), "80 00 00 01");
  line.ask(kEnableJob, words(0, 1, 0), "13 01");
  line.ask(0x0F, words(0, 1, 0), "00 01 13 01");
  line.heard();
  plc.cycles(3);
  EXPECT_EQ(line.heard(), "");
  EXPECT_EQ(line.ask(kEnableJob, words(0, 1, 0), "13 01"), "answer 0E 04 D0 A5");
}

constexpr std::string_view kFault =
    "FUNCTION FC 1 : VOID\nVAR_TEMP\n t : WORD;\nEND_VAR\nBEGIN\nNETWORK\n L W#16#1234;\n T t;\n"
    " L 9;\n AUF DB 77;\nEND_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY[0..19] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n"
    " U E 0.0;\n SPBN end;\n UC FC 1;\nend: NOP 0;\nEND_ORGANIZATION_BLOCK\n";

// S7-DIAG-04
TEST(TestStacks, inStopByAFault) {
  ServedPlc plc("a.awl", std::string(kFault));
  TestLine line(plc);
  plc.cycles(1);
  EXPECT_EQ(line.ask(0x03, words(0, 1, 0), "00 00"), "answer 03 01 D0 81");
  plc.monitor().write("E 0.0", "1");
  plc.cycles(2);
  ASSERT_EQ(plc.plc().mode(), controller::Mode::Stop);
  const auto answer = [&](unsigned function, std::string_view data) {
    line.send(function, words(0, 1, 0), data);
    plc.look();
    return line.heard();
  };
  const std::string interrupted = answer(0x03, "00 00");
  EXPECT_TRUE(interrupted.starts_with("answer 03 02 00 00: 00 0C 00 01 00 ")) << interrupted;
  EXPECT_NE(interrupted.find("00 00 00 09 00 00 12 34"), std::string::npos) << interrupted;
  const std::string blocks = answer(0x04, "00 00");
  EXPECT_TRUE(blocks.starts_with("answer 04 03 00 00: 00 0C 00 01 00 ")) << blocks;
  EXPECT_NE(blocks.find(" 00 08 00 01 00 "), std::string::npos) << blocks;
  EXPECT_EQ(blocks.size(), 20 + 3u * (16 + 28) - 1) << blocks;
  const std::string local = answer(0x05, "01 01");
  EXPECT_TRUE(local.starts_with("answer 05 04 00 00: 00 0C 00 01 00 ")) << local;
  EXPECT_NE(local.find(" 00 02 12 34 01 00 00 00 "), std::string::npos) << local;
  EXPECT_EQ(answer(0x05, "01 07"), "answer 05 05 00 00");
  // The start information of OB 1: class, first scan or not, priority 1, OB 1.
  EXPECT_NE(interrupted.find(" 11 03 01 01 "), std::string::npos) << interrupted;
}

}  // namespace
}  // namespace merker::served
