// Block-related messages: System Software for S7-300/400, volume 2, 24.12 to 24.15.
#include "system/alarms.h"

#include <gtest/gtest.h>

namespace merker::system {
namespace {

using enum Alarms::Result;

Alarms::Result call(Alarms& alarms, std::uint16_t function, std::uint32_t number, bool signal,
                    std::int64_t time = 0) {
  return alarms.report({number, function, 0, {signal, time, {}}});
}

// "17:1+" number, signal, "+" acknowledged; "a" an acknowledgement; "!" transitions are lost.
std::string taken(Alarms& alarms) {
  std::string text;
  for (const AlarmMessage& m : alarms.take()) {
    if (!text.empty()) text += ' ';
    text += std::to_string(m.alarm.number) + (m.isAcknowledgement ? "a" : ":");
    text += m.signal.state ? '1' : '0';
    if (m.alarm.acknowledged) text += '+';
    if (m.alarm.overflow) text += '!';
  }
  return text;
}

TEST(Alarms, EachCallInvertsTheSignal) {
  Alarms alarms;
  alarms.logOn();
  EXPECT_EQ(call(alarms, 18, 0, true), BadNumber);
  EXPECT_EQ(call(alarms, 18, 7, false), FirstIsZero);
  EXPECT_EQ(call(alarms, 18, 7, true), Good);
  EXPECT_EQ(call(alarms, 18, 7, true), SameSignal);
  EXPECT_EQ(call(alarms, 17, 7, false), OtherFunction);
  EXPECT_EQ(call(alarms, 18, 7, false), Good);
  EXPECT_EQ(taken(alarms), "7:1+ 7:0+");
  EXPECT_EQ(alarms.find(7), nullptr);  // its memory is free again
  EXPECT_EQ(call(alarms, 17, 7, true), Good);
}

TEST(Alarms, AMessageWaitsForItsAcknowledgement) {
  for (const std::uint16_t function : {17, 107}) {
    Alarms alarms;
    alarms.logOn();
    EXPECT_EQ(call(alarms, function, 5, true), Good);
    EXPECT_EQ(call(alarms, function, 5, false), Good);
    ASSERT_NE(alarms.find(5), nullptr);
    EXPECT_FALSE(alarms.find(5)->acknowledged);
    EXPECT_TRUE(alarms.acknowledge(5));
    EXPECT_FALSE(alarms.acknowledge(5));
    EXPECT_EQ(alarms.find(5), nullptr);
    EXPECT_EQ(taken(alarms), "5:1 5:0 5a0+");
  }
}

TEST(Alarms, ALockedMessageIsNotSent) {
  Alarms alarms;
  alarms.logOn();
  EXPECT_TRUE(alarms.lock(7, true));
  EXPECT_EQ(call(alarms, 18, 7, true), Good);
  EXPECT_EQ(call(alarms, 18, 8, true), Good);
  EXPECT_EQ(taken(alarms), "8:1+");
  EXPECT_TRUE(alarms.lock(7, false));
  EXPECT_EQ(call(alarms, 18, 7, false), Good);
  EXPECT_EQ(taken(alarms), "7:0+");
  for (std::uint32_t number = 1; number <= Alarms::kMost; ++number)
    EXPECT_TRUE(alarms.lock(number, true));
  EXPECT_FALSE(alarms.lock(100, true));
  EXPECT_TRUE(alarms.lock(7, true));
}

TEST(Alarms, ItsComingIsKept) {
  Alarms alarms;
  call(alarms, 17, 5, true, 1000);
  call(alarms, 17, 5, false, 2000);
  EXPECT_EQ(alarms.find(5)->coming.milliseconds, 1000);
  EXPECT_EQ(alarms.find(5)->last.milliseconds, 2000);
}

TEST(Alarms, AnAcknowledgementCountsForOneComing) {
  Alarms alarms;
  alarms.logOn();
  call(alarms, 17, 5, true);
  alarms.acknowledge(5);
  ASSERT_NE(alarms.find(5), nullptr);
  EXPECT_TRUE(alarms.find(5)->acknowledged);
  alarms.take();
  call(alarms, 17, 5, false);
  call(alarms, 17, 5, true);
  EXPECT_FALSE(alarms.find(5)->acknowledged);
}

// Two transitions wait at most; a third is lost, and the next message that is sent says so.
TEST(Alarms, LostTransitions) {
  Alarms alarms;
  alarms.logOn();
  call(alarms, 17, 5, true);
  call(alarms, 17, 5, false);
  EXPECT_EQ(call(alarms, 17, 5, true), Overflow);
  EXPECT_FALSE(alarms.find(5)->last.state);  // as the last call that counted
  EXPECT_EQ(taken(alarms), "5:1! 5:0");
  EXPECT_EQ(call(alarms, 17, 5, true), Good);
  EXPECT_EQ(taken(alarms), "5:1");
}

TEST(Alarms, WithoutADeviceNothingIsSent) {
  Alarms alarms;
  EXPECT_EQ(call(alarms, 17, 5, true), NobodyListens);
  EXPECT_TRUE(alarms.find(5)->last.state);  // a device that logs on later finds it
  alarms.logOn();
  EXPECT_EQ(taken(alarms), "");
  call(alarms, 17, 6, true);
  alarms.logOff();
  EXPECT_EQ(taken(alarms), "");
  alarms.logOff();
  EXPECT_EQ(call(alarms, 17, 8, true), NobodyListens);
}

TEST(Alarms, MemoryIsLimited) {
  Alarms alarms;
  alarms.logOn();
  for (std::uint32_t i = 1; i <= Alarms::kMost; ++i) EXPECT_EQ(call(alarms, 18, i, true), Good);
  EXPECT_EQ(call(alarms, 18, 99, true), NoMemory);
  call(alarms, 18, 1, false);
  EXPECT_EQ(call(alarms, 18, 99, true), Good);
  alarms.clear();
  EXPECT_TRUE(alarms.list().empty());
  EXPECT_EQ(taken(alarms), "");
}

}  // namespace
}  // namespace merker::system
