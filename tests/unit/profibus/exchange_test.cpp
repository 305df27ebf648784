// PROFIBUS-DP between master and slaves (S7-NET-10, S7-NET-25, S7-SFC-06): when data come and go,
// SYNC and FREEZE, what SFC 13 reads, what a broken line does.
#include "profibus/exchange.h"

#include <gtest/gtest.h>

#include "profibus/slave_diagnosis.h"

namespace merker::profibus {
namespace {

// A slave with a byte of inputs and one of outputs at the same address.
io::Slave slave(std::uint8_t address, std::uint32_t byte) {
  io::Slave made;
  made.address = address;
  made.name = "S" + std::to_string(address);
  made.ident = 0x7F01;
  made.groups = 1;
  made.sync = made.freeze = true;
  io::Module module;
  module.own = io::slaveModule("1 DI 1 DO", 1, 1);
  module.type = module.own.get();
  module.parameters = io::Parameters::of(*module.type);
  module.rack = io::kSlaveRack + address;
  module.slot = 1;
  module.inputStart = module.outputStart = byte;
  made.modules.push_back(module);
  return made;
}

io::Rack rackOf(std::int64_t rate) {
  Problems problems;
  const CpuModel& model = *findCpuModel("314C-2 DP");
  io::Configuration configuration = io::configure({}, model, problems);
  io::DpMaster master;
  master.rate = rate;
  master.slaves = {slave(4, 10), slave(5, 11)};
  io::addSlaves(configuration, std::move(master), problems);
  EXPECT_TRUE(problems.empty());
  return io::Rack(std::move(configuration));
}

constexpr std::int64_t kBits[] = {300 + 317 + 22, 300 + 2 * (317 + 22)};  // up to the end of a turn
Instant bits(std::int64_t count, std::int64_t rate) {
  return Instant{(count * 1'000'000'000 + rate - 1) / rate};
}

TEST(Exchange, TheBusCycleFollowsRateAndBytes) {
  for (const std::int64_t rate : {9'600, 187'500, 1'500'000, 12'000'000}) {
    const io::Rack rack = rackOf(rate);
    const BusCycle cycle = busCycle(*rack.configuration().dp);
    EXPECT_EQ(cycle.length.ns, bits(kBits[1], rate).ns);
    EXPECT_EQ(cycle.ends[0].ns, bits(kBits[0], rate).ns);
  }
}

TEST(Exchange, ATurnBeginsWhereTheOneBeforeItEnds) {
  constexpr std::int64_t kRate = 1'500'000;
  io::Rack rack = rackOf(kRate);
  const Exchange exchange(rack);
  const Instant begin = bits(kBits[0], kRate);
  EXPECT_EQ(exchange.turnBegins(1, Instant{}), begin);
  EXPECT_EQ(exchange.turnBegins(1, begin), begin);
  EXPECT_EQ(exchange.turnBegins(1, Instant{begin.ns + 1}),
            begin + busCycle(exchange.master()).length);
}

TEST(Exchange, ASlaveHasItsTurnInEachCycle) {
  constexpr std::int64_t kRate = 1'500'000;
  io::Rack rack = rackOf(kRate);
  Exchange exchange(rack);
  EXPECT_EQ(exchange.next(), Instant::never());  // nothing changes: nothing is done
  exchange.written(11, 0x81, Instant{});
  EXPECT_EQ(exchange.next(), bits(kBits[1], kRate));
  EXPECT_TRUE(exchange.advance(Instant{bits(kBits[1], kRate).ns - 1}).empty());
  rack.disableOutputs(false);
  EXPECT_EQ(rack.putOut(11), 0);
  (void)exchange.advance(bits(kBits[1], kRate));
  EXPECT_EQ(rack.putOut(11), 0x81);
  EXPECT_EQ(exchange.next(), Instant::never());

  // The turn of the first slave in this cycle is over: it has the next one.
  const Instant now = bits(kBits[0] + 1, kRate);
  rack.deliver(10, 0xFF, 7, now);
  exchange.inputChanged(10, now);
  EXPECT_EQ(exchange.next().ns, busCycle(exchange.master()).length.ns + bits(kBits[0], kRate).ns);
  const auto seen = exchange.advance(exchange.next());
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].first, 10u);
}

TEST(Exchange, SyncHoldsOutputsAndFreezeInputs) {
  io::Rack rack = rackOf(1'500'000);
  rack.disableOutputs(false);
  Exchange exchange(rack);
  const Instant late{Instant{}.ns + 1'000'000'000};
  const auto put = [&](std::uint8_t value) {
    exchange.written(10, value, Instant{});
    return exchange.advance(late).size();
  };
  const auto command = [](Control one) { return static_cast<std::uint8_t>(one); };
  EXPECT_EQ(put(1), 1u);
  exchange.control(1, command(Control::Sync), Instant{});
  (void)exchange.advance(late);
  (void)put(2);
  EXPECT_EQ(rack.putOut(10), 1);  // held
  exchange.control(1, command(Control::Sync), Instant{});
  (void)exchange.advance(late);
  EXPECT_EQ(rack.putOut(10), 2);  // taken over by the next SYNC
  exchange.control(1, command(Control::Unsync), Instant{});
  (void)put(3);
  EXPECT_EQ(rack.putOut(10), 3);
  exchange.control(1, command(Control::Freeze), Instant{});
  EXPECT_EQ(exchange.advance(late).size(), 2u);  // FREEZE shows both slaves once
  EXPECT_EQ(put(4), 0u);
  exchange.control(2, command(Control::Unfreeze), Instant{});  // another group
  EXPECT_EQ(put(5), 0u);
  exchange.control(1, command(Control::Unfreeze), Instant{});
  EXPECT_EQ(exchange.advance(late).size(), 2u);
}

using Data = std::vector<std::uint8_t>;

TEST(SlaveDiagnosis, SaysWhoItIsAndWhatIsWrong) {
  io::Rack rack = rackOf(1'500'000);
  const io::Slave& first = rack.configuration().dp->slaves[0];
  EXPECT_EQ(slaveDiagnosis(rack, first), (Data{0x00, 0x0C, 0x00, 0x02, 0x7F, 0x01}));
  rack.fault(*rack.module("DP4/1"), io::FaultKind::Removed, {}, true);
  EXPECT_EQ(slaveDiagnosis(rack, first), (Data{0x08, 0x0C, 0x00, 0x02, 0x7F, 0x01, 0x42, 0x01}));
  rack.fault(*rack.module("S4"), io::FaultKind::RackPower, {}, true);
  EXPECT_EQ(slaveDiagnosis(rack, first), (Data{0x01, 0x04, 0x00, 0xFF, 0x7F, 0x01}));
}

// What lies behind the place is not reached; a short circuit leaves nothing.
TEST(SlaveDiagnosis, ABrokenLineTakesAllBehindItAlong) {
  io::Rack rack = rackOf(1'500'000);
  const auto answers = [&] { return std::pair(rack.answersInput(10), rack.answersInput(11)); };
  const auto events = [&] {
    std::string text;
    for (const ModuleEvent& event : rack.takeEvents())
      text += (event.kind == ModuleEvent::Kind::StationFailed ? "-" : "+") +
              std::to_string(event.points & 0xFF);
    return text;
  };
  const auto fault = [&](std::string_view name, io::FaultKind kind, bool there) {
    EXPECT_TRUE(rack.fault(*rack.module(name), kind, {}, there));
  };
  fault("S5", io::FaultKind::LineBreak, true);
  EXPECT_EQ(answers(), std::pair(true, false));
  EXPECT_EQ(events(), "-5");
  fault("S4", io::FaultKind::LineBreak, true);
  EXPECT_EQ(answers(), std::pair(false, false));
  EXPECT_EQ(events(), "-4");  // 5 was lost already
  fault("S5", io::FaultKind::LineBreak, false);
  EXPECT_EQ(events(), "");
  fault("S4", io::FaultKind::LineBreak, false);
  EXPECT_EQ(events(), "+4+5");
  fault("S5", io::FaultKind::ShortCircuit, true);
  EXPECT_EQ(answers(), std::pair(false, false));
  EXPECT_EQ(events(), "-4-5");
  EXPECT_FALSE(rack.fault(*rack.module("S4"), io::FaultKind::Fuse, {}, true));
}

// S7-OBI-11: which station of which master system, and its diagnostic address.
TEST(SlaveDiagnosis, OB86SaysWhichStation) {
  io::Rack rack = rackOf(1'500'000);
  (void)rack.takeEvents();
  rack.fault(*rack.module("S5"), io::FaultKind::RackPower, {}, true);
  const auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].address, 1023);
  EXPECT_EQ(events[0].points, 1021u << 16 | 1u << 8 | 5u);
}

}  // namespace
}  // namespace merker::profibus
