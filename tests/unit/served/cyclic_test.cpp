// Cyclic reads in the time of the PLC.
#include "served/cyclic.h"

#include "served_plc.h"

namespace merker::served {
namespace {

using s7comm::CyclicRead;
using s7comm::Error;
using s7comm::Outlet;

// One value, as it is.
CyclicRead reading(const Range& range, bool onChange = false, std::uint32_t milliseconds = 100) {
  return {static_cast<std::uint8_t>(onChange ? 5 : 1),
          onChange,
          milliseconds,
          {range},
          [](const std::vector<Value>& values) { return values.at(0).octets; }};
}

class EachCyclic : public EachFamily {
 protected:
  void SetUp() override {
    plc.exchange.opened();
    client->setRoom(200);
  }
  Subscribed subscribe(const CyclicRead& read, std::optional<std::uint8_t> job = std::nullopt) {
    Subscribed made;
    plc.exchange.subscribe(client, job, read,
                           [&](Error error, std::uint8_t number, const std::vector<Value>& values) {
                             made = {error, number, values};
                           });
    plc.cycles(1);
    return made;
  }
  Error unsubscribe(std::uint8_t job) {
    Error how = Error::CannotBeDone;
    plc.exchange.unsubscribe(client, job, [&](Error error) { how = error; });
    plc.cycles(1);
    return how;
  }
  void wait(std::int64_t milliseconds) {
    plc.plc().advanceTo(plc.plc().now() + Duration::milliseconds(milliseconds));
  }
  std::vector<Bytes> heard() {
    std::vector<Bytes> all;
    while (auto one = client->take()) {
      EXPECT_EQ(one->group, 2);
      all.push_back(std::move(one->octets));
    }
    return all;
  }
  std::shared_ptr<Outlet> client = std::make_shared<Outlet>();
};
INSTANTIATE_TEST_SUITE_P(Families, EachCyclic, ::testing::Values(Family::Station, Family::Control));

// S7-NET-26
TEST_P(EachCyclic, valuesComeAtTheInterval) {
  const Subscribed made = subscribe(reading(flags(11, 1)));
  EXPECT_EQ(made.error, Error::None);
  EXPECT_EQ(made.job, 1);
  EXPECT_EQ(made.values.at(0).code, ItemCode::Done);
  wait(1'050);
  const auto values = heard();
  EXPECT_EQ(values.size(), 10u);
  EXPECT_NE(values.front(), values.back());
  EXPECT_EQ(unsubscribe(1), Error::None);
  EXPECT_EQ(unsubscribe(1), Error::NoSuchReading);
  wait(500);
  EXPECT_TRUE(heard().empty());
}

TEST_P(EachCyclic, onChangeOnlyThen) {
  subscribe(reading(flags(200, 1), true));
  wait(500);
  EXPECT_TRUE(heard().empty());
  plc.writeNow(flags(200, 1), {0x42});
  wait(500);
  EXPECT_EQ(heard(), (std::vector<Bytes>{{0x42}}));
}

TEST_P(EachCyclic, aJobIsModified) {
  EXPECT_EQ(subscribe(reading(flags(200, 1), true), 1).error, Error::NoSuchReading);
  EXPECT_EQ(subscribe(reading(flags(200, 1), true)).job, 1);
  EXPECT_EQ(subscribe(reading(flags(202, 2), true), 1).job, 1);
  plc.writeNow(flags(200, 3), {1, 1, 7});
  wait(300);
  EXPECT_EQ(heard(), (std::vector<Bytes>{{7, 0}}));
  EXPECT_EQ(subscribe(reading(flags(200, 1))).job, 2);
  EXPECT_EQ(subscribe(reading(flags(200, 1), true), 2).error,
            Error::NoSuchReading);  // not on change
}

// Recorded requests have the number that another CPU gave: the last job is meant.
TEST_P(EachCyclic, aNumberThatNoJobHas) {
  subscribe(reading(flags(200, 1), true));
  EXPECT_EQ(subscribe(reading(flags(202, 2), true), 9).job, 1);
  subscribe(reading(flags(200, 1)));
  EXPECT_EQ(unsubscribe(9), Error::None);
  EXPECT_EQ(unsubscribe(2), Error::None);  // 2 had gone: 1
  EXPECT_EQ(unsubscribe(1), Error::NoSuchReading);
}

TEST_P(EachCyclic, jobsOfAConnectionAreLimited) {
  for (std::size_t i = 1; i <= CyclicTask::kMost; ++i)
    EXPECT_EQ(subscribe(reading(flags(200, 1))).job, i);
  EXPECT_EQ(subscribe(reading(flags(200, 1))).error, Error::TooManyReadings);
  EXPECT_EQ(unsubscribe(7), Error::None);
  EXPECT_EQ(subscribe(reading(flags(200, 1))).job, 7);
  client->close();
  wait(100);
  client = std::make_shared<Outlet>();
  client->setRoom(200);
  EXPECT_EQ(subscribe(reading(flags(200, 1))).job, 1);
}

// In STOP time goes on, and so do they; a client that does not read has the first ones.
TEST_P(EachCyclic, inStopAndWithoutAReader) {
  subscribe(reading(flags(200, 1)));
  plc.monitor().stop();
  for (std::size_t i = 0; i < 2 * Outlet::kMostWaiting; ++i) wait(100), plc.look();
  EXPECT_EQ(heard().size(), Outlet::kMostWaiting);
  EXPECT_GT(client->lost(), 50u);
}

}  // namespace
}  // namespace merker::served
