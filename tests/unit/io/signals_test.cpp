// Terminals with signals that are known in advance: what passes the input delay when somebody
// looks.
#include <gtest/gtest.h>

#include "make.h"
#include "signal/pulse_train.h"

namespace merker::io {
namespace {

std::shared_ptr<const signal::Signal> train(std::int64_t millihertz, std::uint32_t duty,
                                            std::int64_t startMs, std::int64_t count = 0) {
  signal::Pulses pulses = signal::pulsesOf(millihertz, duty, at(startMs));
  pulses.count = count;
  return std::make_shared<signal::PulseTrain>(pulses);
}

struct Input {
  explicit Input(std::uint32_t rising = 0, std::uint32_t falling = 0) {
    Module module = onBoard(2);  // input delay 3 ms
    module.parameters.risingEdges = rising;
    module.parameters.fallingEdges = falling;
    rack.emplace(good({module}));
    terminal = *rack->terminal("2.2", Side::DigitalInput, 1);
  }
  bool shown(std::int64_t us) {
    rack->settle(Instant{us * 1000});
    return (rack->inputs()[124] & 2) != 0;
  }
  std::optional<Rack> rack;
  Terminal terminal;
};

// S7-HWCFG-09: 5 ms high, 5 ms low; each level passes when it has lasted for 3 ms.
TEST(AttachedSignal, PassesTheInputDelay) {
  Input input;
  input.rack->attach(input.terminal, train(100'000, 500, 10), at(0));
  EXPECT_TRUE(input.rack->hasSignals());
  EXPECT_FALSE(input.shown(12'999));
  EXPECT_TRUE(input.shown(13'000));
  EXPECT_TRUE(input.shown(17'999));
  EXPECT_FALSE(input.shown(18'000));
  EXPECT_FALSE(input.shown(22'999));
  EXPECT_TRUE(input.shown(23'000));
  EXPECT_TRUE(input.rack->level(input.terminal));
  EXPECT_FALSE(input.shown(1'000'012'999));
  EXPECT_TRUE(input.shown(1'000'013'000));
}

// 2 ms high, 8 ms low, and the other way round: the short level is never seen.
TEST(AttachedSignal, ShortPulsesAreNotSeen) {
  Input low, high;
  low.rack->attach(low.terminal, train(100'000, 200, 0), at(0));
  high.rack->attach(high.terminal, train(100'000, 800, 0), at(0));
  EXPECT_TRUE(high.shown(3'000));
  for (std::int64_t us = 5'000; us < 60'000; us += 500) {
    EXPECT_FALSE(low.shown(us)) << us;
    EXPECT_TRUE(high.shown(us)) << us;
  }
}

// Neither level lasts: the module goes on showing what it showed before.
TEST(AttachedSignal, TooFastLeavesTheInputAsItWas) {
  Input input;
  input.rack->deliver(124, 2, 2, at(0));
  input.rack->attach(input.terminal, train(1'000'000, 500, 0), at(100));
  EXPECT_TRUE(input.shown(100'500));
  EXPECT_TRUE(input.shown(500'500));
}

// Behind the last pulse the level stays; a level that is set takes the signal's place.
TEST(AttachedSignal, EndsByItselfOrByALevel) {
  Input input;
  input.rack->attach(input.terminal, train(100'000, 500, 0, 2), at(0));
  EXPECT_TRUE(input.shown(14'000));
  EXPECT_FALSE(input.shown(40'000));
  input.rack->attach(input.terminal, train(100'000, 500, 50), at(50));
  EXPECT_TRUE(input.shown(54'000));
  input.rack->setLevel(input.terminal, true, at(54));
  EXPECT_FALSE(input.rack->hasSignals());
  EXPECT_TRUE(input.shown(200'000));
  input.rack->setLevel(input.terminal, false, at(200));
  input.rack->advance(at(203));
  EXPECT_EQ(input.rack->inputs()[124], 0);
}

// S7-OBI-06: an input that interrupts is followed edge by edge, each 3 ms later.
TEST(AttachedSignal, InterruptsAtEachEdge) {
  Input input(2, 0);
  input.rack->attach(input.terminal, train(100'000, 500, 10, 3), at(0));
  int edges = 0;
  Instant last;
  while (input.rack->next() < at(1000)) {
    const Instant now = input.rack->next();
    input.rack->advance(now);
    for (const ModuleEvent& event : input.rack->takeEvents()) {
      EXPECT_EQ(event.points, 2u);
      ++edges;
      last = now;
    }
  }
  EXPECT_EQ(edges, 3);
  EXPECT_EQ(last, at(33));  // the third pulse begins at 30 ms
}

TEST(AttachedSignal, OutputsHaveNone) {
  Input input;
  input.rack->attach(*input.rack->terminal("2.2", Side::DigitalOutput, 0), train(100'000, 500, 0),
                     at(0));
  EXPECT_FALSE(input.rack->hasSignals());
}

// Of an input that is watched each change is told, with the signal that lies there from then on.
TEST(AttachedSignal, WatchedInputsTellTheirEdges) {
  Input input;
  input.rack->watch(Watcher::Counting, input.terminal);
  input.rack->setLevel(input.terminal, true, at(1));
  const auto pulses = train(100'000, 500, 0);
  input.rack->attach(input.terminal, pulses, at(6));
  input.rack->setLevel(*input.rack->terminal("2.2", Side::DigitalInput, 0), true, at(7));
  const auto edges = input.rack->takeEdges(Watcher::Counting);
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_EQ(edges[0].terminal, input.terminal);
  EXPECT_TRUE(edges[0].level);
  EXPECT_EQ(edges[0].at, at(1));
  EXPECT_EQ(edges[0].signal, nullptr);
  EXPECT_FALSE(edges[1].level);  // 6 ms: the pulse is over
  EXPECT_EQ(edges[1].at, at(6));
  EXPECT_EQ(edges[1].signal, pulses);
}

TEST(AttachedSignal, ShowsBytesOfAChannel) {
  Rack rack(good({}));
  const std::uint32_t counters = *rack.module("2.4");
  rack.show(counters, std::uint32_t{1}, std::uint32_t{0x12345678});
  EXPECT_EQ(word(rack, 772), 0x1234);
  EXPECT_EQ(word(rack, 774), 0x5678);
  EXPECT_EQ(word(rack, 768), 0);
  EXPECT_EQ(word(rack, 776), 0);
}

}  // namespace
}  // namespace merker::io
