// Jobs of group 1 on the wire, as programming devices write them.
#include "s7comm/test_job.h"

#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

// Requests of group 1 have the head that elsewhere asks for the rest of an answer.
TEST(TestJob, theJobListIsAskedFor) {
  Line line;
  EXPECT_EQ(
      line.say("32 07 00 00 00 3B 00 0C 00 20 00 01 12 08 12 41 10 00 00 00 00 00 FF 09 00 1C "
               "00 14 00 04 00 00 00 00 00 01 00 00 00 01 00 01 00 01 00 01 00 01 00 00 "
               "00 00 00 00"),
      "32 07 00 00 00 3B 00 0C 00 0C 00 01 12 08 12 81 10 09 00 00 00 00 "
      "FF 09 00 08 00 04 00 00 01 00 00 01");
  EXPECT_EQ(line.plc.tested.function, TestFunction::List);
}

TEST(TestJob, aJobIsDeleted) {
  Line line;
  line.say(
      "32 07 00 00 00 40 00 0C 00 20 00 01 12 08 12 41 0F 00 00 00 00 00 FF 09 00 1C "
      "00 14 00 04 00 00 00 00 00 01 00 00 00 00 00 01 00 01 00 01 00 01 00 00 00 01 09 04");
  EXPECT_EQ(line.plc.tested.function, TestFunction::Delete);
  EXPECT_EQ(line.plc.tested.other, (TestName{0x09, 4}));
}

TEST(TestJob, aForceJobIsReplaced) {
  Line line;
  line.say(
      "32 07 00 00 00 3D 00 0C 00 52 00 01 12 08 12 41 12 00 00 00 00 00 FF 09 00 4E "
      "00 14 00 36 00 00 00 00 00 01 00 00 00 00 00 01 00 01 00 01 00 01 00 00 "
      "00 00 09 04 00 14 00 1A 00 00 01 00 00 02 00 04 00 01 00 01 00 01 00 01 00 01 00 00 "
      "00 02 20 01 00 00 00 02 20 02 00 00 00 02 00 09 00 01 01 00 00 09 00 01 00 00");
  const TestRequest& heard = line.plc.tested;
  EXPECT_EQ(heard.function, TestFunction::Replace);
  EXPECT_EQ(heard.other, (TestName{0x09, 4}));
  EXPECT_EQ(heard.job.how, 0x100);
  EXPECT_EQ(heard.job.often, 2);
  ASSERT_EQ(heard.job.items.size(), 2u);
  EXPECT_EQ(heard.job.items[0].range,
            (Range{.memory = Memory::Output, .begin = 2, .octets = 1, .bit = 1, .oneBit = true}));
  EXPECT_EQ(heard.job.items[0].value, Bytes{1});
  EXPECT_EQ(heard.job.items[1].range.bit, 2);
  EXPECT_EQ(forceJob(4, heard.job.items).parameters, heard.job.parameters);
  EXPECT_EQ(forceJob(4, heard.job.items).data, heard.job.data);
}

TEST(TestJob, timersCountersAndTheirNumbers) {
  Line line;
  line.say(
      "32 07 00 00 00 40 00 0C 00 2A 00 01 12 08 12 41 02 00 00 00 00 00 FF 09 00 26 "
      "00 14 00 0E 00 00 00 01 00 00 00 0E 00 01 00 01 00 01 00 01 00 01 02 00 "
      "00 02 54 01 00 01 00 03 64 02 00 01 00 05");
  const TestJob& job = line.plc.tested.job;
  EXPECT_EQ(job.how, 1);
  EXPECT_EQ(job.event, static_cast<std::uint16_t>(TriggerEvent::CycleBegin));
  ASSERT_EQ(job.items.size(), 2u);
  EXPECT_EQ(job.items[0].range, (Range{.memory = Memory::Timer, .begin = 3, .octets = 2}));
  EXPECT_EQ(job.items[1].range, (Range{.memory = Memory::Counter, .begin = 5, .octets = 4}));
}

// Cut off anywhere, each octet changed to anything: an answer, and no value of another length.
TEST(TestJob, everyOctetMayBeWrong) {
  const Bytes request =
      hex("32 07 00 00 00 3D 00 0C 00 52 00 01 12 08 12 41 12 00 00 00 00 00 FF 09 00 4E "
          "00 14 00 36 00 00 00 00 00 01 00 00 00 00 00 01 00 01 00 01 00 01 00 00 "
          "00 00 09 04 00 14 00 1A 00 00 01 00 00 02 00 04 00 01 00 01 00 01 00 01 00 01 00 00 "
          "00 02 20 01 00 00 00 02 20 02 00 00 00 02 00 09 00 01 01 00 00 09 00 01 00 00");
  Line line;
  for (std::size_t i = 10; i < request.size(); ++i)
    for (unsigned value = 0; value < 256; ++value) {
      Bytes changed = request;
      changed[i] = static_cast<std::uint8_t>(value);
      line.plc.tested = {};
      EXPECT_NE(line.say(changed), "");
      for (const TestItem& item : line.plc.tested.job.items)
        EXPECT_TRUE(item.code != ItemCode::Done || item.value.empty() ||
                    item.value.size() == item.range.octets);
    }
}

}  // namespace
}  // namespace merker::s7comm
