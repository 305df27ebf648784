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

TEST(Areas, CountsAboveTheRangeAreTheHighest) {
  const auto read = fromAreas({{kCounterArea, {0, 0xFF, 0xFF}}});
  EXPECT_EQ(read.counters.at(0).count, 999);
}

}  // namespace
}  // namespace merker::store::test
