// Channels, pins and frequencies of the CPU models (technology manual 5.2.2, 5.3.3).
#include <gtest/gtest.h>

#include <vector>

#include "catalogue/counting.h"

namespace merker {
namespace {

const CountingType& of(std::string_view name) { return *countingType(*findCpuModel(name)); }

// CNT-OVW-01, CNT-OVW-03, CNT-PARAM-08, POS-OVW-03
TEST(CountingPins, ChannelsAndFrequencies) {
  EXPECT_EQ(of("312C").channels.size(), 2u);
  EXPECT_EQ(of("313C").channels.size(), 3u);
  EXPECT_EQ(of("313C-2 DP").channels.size(), 3u);
  EXPECT_EQ(of("314C-2 PtP").channels.size(), 4u);
  EXPECT_EQ(of("312C").frequencies.front(), 10u);
  EXPECT_EQ(of("313C-2 PtP").frequencies.front(), 30u);
  EXPECT_EQ(of("314C-2 PN/DP").frequencies.front(), 60u);
  EXPECT_EQ(countingType(*findCpuModel("318-2")), nullptr);
  const std::vector<std::uint32_t> all{60, 30, 10, 5, 2, 1};
  const auto listed = [](std::string_view name) {
    return std::vector<std::uint32_t>(of(name).frequencies.begin(), of(name).frequencies.end());
  };
  EXPECT_EQ(listed("314C-2 DP"), all);
  EXPECT_EQ(listed("313C"), std::vector<std::uint32_t>(all.begin() + 1, all.end()));
  EXPECT_EQ(listed("312C"), std::vector<std::uint32_t>(all.begin() + 2, all.end()));
}

void expectPins(const CountingPins& pins, std::initializer_list<unsigned> channels,
                std::initializer_list<unsigned> numbers) {
  const CountingPin all[] = {pins.a, pins.b, pins.gate, pins.latch, pins.output};
  std::size_t i = 0;
  for (const unsigned channel : channels) EXPECT_EQ(all[i++].channel, channel);
  i = 0;
  for (const unsigned number : numbers) EXPECT_EQ(all[i++].pin, number);
}

// CNT-PIN-02, CNT-PIN-03
TEST(CountingPins, Cpu312) {
  EXPECT_EQ(of("312C").connector, "X1");
  expectPins(of("312C").channels[0], {0, 1, 2, 6, 0}, {2, 3, 4, 8, 14});
  expectPins(of("312C").channels[1], {3, 4, 5, 7, 1}, {5, 6, 7, 9, 15});
}

// CNT-PIN-05, CNT-PIN-06, CNT-PIN-07, CNT-PIN-08
TEST(CountingPins, Cpu313AndTheFirstThreeOf314) {
  EXPECT_EQ(of("313C").connector, "X2");
  EXPECT_EQ(of("313C-2 DP").connector, "X1");
  EXPECT_EQ(of("314C-2 DP").connector, "X2");
  for (const char* name : {"313C", "313C-2 PtP", "314C-2 PtP"}) {
    expectPins(of(name).channels[0], {0, 1, 2, 12, 0}, {2, 3, 4, 16, 22});
    expectPins(of(name).channels[1], {3, 4, 5, 13, 1}, {5, 6, 7, 17, 23});
    expectPins(of(name).channels[2], {6, 7, 8, 14, 2}, {8, 9, 12, 18, 24});
  }
}

// CNT-PIN-09
TEST(CountingPins, TheFourthChannelOf314) {
  expectPins(of("314C-2 PtP").channels[3], {9, 10, 11, 15, 3}, {13, 14, 15, 19, 25});
}

}  // namespace
}  // namespace merker
