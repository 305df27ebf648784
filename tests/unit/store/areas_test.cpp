// Areas whose bytes no CPU has written: refused, never believed.
#include "store/areas.h"

#include <gtest/gtest.h>

#include "card.h"
#include "store/checksum.h"
#include "store/database.h"

namespace merker::store::test {
namespace {

TEST(Checksum, OfTheTestString) {
  const std::string text = "123456789";  // check value of CRC-32
  EXPECT_EQ(crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}), 0xCBF43926u);
}

TEST(Areas, ComeBack) {
  const block::RetentiveData data = retentiveData(9);
  const auto read = fromAreas({{kStateArea, stateBytes(data)},
                               {kFlagArea, data.flags},
                               {kTimerArea, timerBytes(data)},
                               {kCounterArea, counterBytes(data)},
                               {kMeterArea, meterBytes(data)},
                               {kDiagnosticArea, diagnosticBytes(data)},
                               {{"DB", 1}, data.dataBlocks[0].bytes},
                               {{"DB", 2}, data.dataBlocks[1].bytes},
                               {{"made DB", 9}, data.dataBlocks[2].bytes}});
  EXPECT_EQ(read, withoutCount(data));
}

TEST(Areas, RefuseWhatNoCpuHas) {
  EXPECT_THROW(fromAreas({{{"E", 0}, {1}}}), Damage);
  EXPECT_THROW(fromAreas({{kStateArea, Bytes(16)}}), Damage);        // cut off
  EXPECT_THROW(fromAreas({{kStateArea, Bytes(17, 0x7F)}}), Damage);  // in 292 years
  EXPECT_THROW(fromAreas({{kTimerArea, Bytes(13, 5)}}), Damage);     // there is no sixth kind
  EXPECT_THROW(fromAreas({{kTimerArea, Bytes(14)}}), Damage);
  EXPECT_THROW(fromAreas({{kCounterArea, Bytes(3, 0x10)}}), Damage);
  EXPECT_THROW(fromAreas({{kDiagnosticArea, Bytes(12, 0xFF)}}), Damage);
  EXPECT_THROW(fromAreas({{kMeterArea, Bytes(16)}}), Damage);
  EXPECT_THROW(fromAreas({{kDiagnosticArea, Bytes(101 * 38)}}), Damage);  // 100 entries
}

Bytes timer(std::uint8_t kind, std::uint8_t flags, std::uint8_t base) {
  Bytes bytes(13);
  bytes[0] = kind, bytes[1] = flags, bytes[2] = base;
  return bytes;
}

// The last value of each field beside the first that no CPU writes.
TEST(Areas, EndsOfTheFields) {
  EXPECT_EQ(fromAreas({{kTimerArea, timer(4, 15, 3)}}).timers.size(), 1u);
  EXPECT_THROW(fromAreas({{kTimerArea, timer(5, 0, 0)}}), Damage);
  EXPECT_THROW(fromAreas({{kTimerArea, timer(0, 16, 0)}}), Damage);
  EXPECT_THROW(fromAreas({{kTimerArea, timer(0, 0, 4)}}), Damage);
  EXPECT_EQ(fromAreas({{kCounterArea, {15, 0, 0}}}).counters.size(), 1u);
  EXPECT_THROW(fromAreas({{kCounterArea, {16, 0, 0}}}), Damage);
  Bytes meter(17);
  meter[0] = 1;
  EXPECT_TRUE(fromAreas({{kMeterArea, meter}}).meters.at(0).running);
  meter[0] = 2;
  EXPECT_THROW(fromAreas({{kMeterArea, meter}}), Damage);
  EXPECT_EQ(fromAreas({{kCounterArea, {0, 0x03, 0xE7}}}).counters.at(0).count, 999);
  EXPECT_EQ(fromAreas({{kCounterArea, {0, 0x03, 0xE6}}}).counters.at(0).count, 998);
}

// A hundred years of 365.25 days, in nanoseconds, on either side.
TEST(Areas, TimesReachAHundredYears) {
  block::RetentiveData data;
  for (const std::int64_t sign : {1, -1}) {
    data.now = sign * 3'155'760'000LL * 1'000'000'000;
    EXPECT_EQ(fromAreas({{kStateArea, stateBytes(data)}}).now, data.now);
    data.now += sign;
    EXPECT_THROW(fromAreas({{kStateArea, stateBytes(data)}}), Damage);
  }
}

// Each bit of a timer and of a counter comes back as itself.
TEST(Areas, BitsAreNotMixedUp) {
  for (int bit = 0; bit < 4; ++bit) {
    block::RetentiveData data;
    data.timers.push_back({.kind = 2,
                           .startEdge = bit == 0,
                           .enableEdge = bit == 1,
                           .started = bit == 2,
                           .held = bit == 3,
                           .base = 1,
                           .frozen = 345,
                           .end = 678});
    data.counters.push_back({.count = 7,
                             .setEdge = bit == 0,
                             .upEdge = bit == 1,
                             .downEdge = bit == 2,
                             .enableEdge = bit == 3});
    const auto read =
        fromAreas({{kTimerArea, timerBytes(data)}, {kCounterArea, counterBytes(data)}});
    EXPECT_EQ(read.timers, data.timers);
    EXPECT_EQ(read.counters, data.counters);
    EXPECT_EQ(timerBytes(data)[1], 1 << bit);
    EXPECT_EQ(counterBytes(data)[0], 1 << bit);
  }
}

TEST(Areas, CountsAboveTheRangeAreTheHighest) {
  const auto read = fromAreas({{kCounterArea, {0, 0xFF, 0xFF}}});
  EXPECT_EQ(read.counters.at(0).count, 999);
}

}  // namespace
}  // namespace merker::store::test
