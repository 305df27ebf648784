#include "served/system.h"

#include <fmt/format.h>

#include "cpu/switch_panel.h"
#include "served_plc.h"

namespace merker::served {
namespace {

using s7comm::ClockTime;
using s7comm::Control;
using s7comm::Controlled;
using s7comm::Error;

class EachSystem : public EachFamily {
 protected:
  Controlled control(Control wish) {
    Controlled how = Controlled::Refused;
    plc.exchange.control(wish, {}, [&](Controlled answer) { how = answer; });
    if (plc.plc().mode() == controller::Mode::Stop)
      plc.look();
    else
      plc.cycles(1);
    return how;
  }
};
INSTANTIATE_TEST_SUITE_P(Families, EachSystem, ::testing::Values(Family::Station, Family::Control));

TEST_P(EachSystem, stopsAndStarts) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_EQ(control(Control::WarmRestart), Controlled::Already);
  EXPECT_EQ(control(Control::Stop), Controlled::Done);
  EXPECT_EQ(plc.plc().mode(), controller::Mode::Stop);
  EXPECT_EQ(control(Control::Stop), Controlled::Already);
  EXPECT_EQ(control(Control::WarmRestart), Controlled::Done);
  plc.cycles(2);
  EXPECT_EQ(plc.plc().mode(), controller::Mode::Run);
}

// Level 2 is in force at RUN; nobody but who stands there turns the switch away from STOP.
TEST(System, theModeSwitchProtects) {
  ServedPlc plc = ServedPlc::station();
  plc.cycles(1);
  auto* const panel = controller::capability<cpu::SwitchPanel>(plc.plc());
  panel->setSwitch(cpu::SwitchPosition::Run);
  EXPECT_EQ(control(plc.monitor(), Control::Stop, {}), Controlled::Protected);
  EXPECT_EQ(setClock(plc.plc(), {0x26, 1, 1, 0, 0, 0, 0, 0}, {}), Error::NeedsPassword);
  EXPECT_FALSE(isProtected(plc.plc(), {}, 3)) << "reading is allowed";
  panel->setSwitch(cpu::SwitchPosition::RunP);
  EXPECT_EQ(control(plc.monitor(), Control::Stop, {}), Controlled::Done);
  panel->setSwitch(cpu::SwitchPosition::Stop);
  EXPECT_EQ(control(plc.monitor(), Control::WarmRestart, {}), Controlled::Refused);
  EXPECT_EQ(panel->switchPosition(), cpu::SwitchPosition::Stop);
}

// Whoever tests asks what there is: 13h is bit 3 of the third byte.
TEST(System, offersWhatABenchServes) {
  ServedPlc plc = ServedPlc::station();
  const auto list = statusList(plc.plc(), 0x0131, 2);
  ASSERT_EQ(list.data.size(), 40u);
  EXPECT_EQ(Bytes(list.data.begin(), list.data.begin() + 5), (Bytes{0, 2, 0x3E, 0xFF, 0x4F}));
  EXPECT_EQ(Bytes(list.data.begin() + 20, list.data.begin() + 23), (Bytes{0x5F, 0, 0}));
}

// The byte that clients look at is in the first record (0424).
TEST(System, theListsAreThoseOfTheCpu) {
  ServedPlc plc = ServedPlc::station();
  plc.cycles(1);
  const auto mode = statusList(plc.plc(), 0x0424, 0);
  ASSERT_EQ(mode.error, Error::None);
  EXPECT_EQ(mode.recordLength, 20);
  EXPECT_EQ(mode.data.at(3), 8);
  plc.monitor().stop();
  EXPECT_EQ(statusList(plc.plc(), 0x0424, 0).data.at(3), 4);
  EXPECT_EQ(statusList(plc.plc(), 0x00A0, 0).data.at(1), 0x04);  // 4304: by a programming device
  EXPECT_EQ(statusList(plc.plc(), 0x0999, 0).error, Error::NoSuchList);
  EXPECT_EQ(statusList(plc.plc(), 0x0111, 0x77).error, Error::NoInformation);
}

// What stands of a connection and what is free, also when the last one has gone (S7-LIM-05).
TEST(System, theListsHaveTheConnections) {
  ServedPlc plc = ServedPlc::station();
  const auto words = [&](std::uint16_t list) {
    const auto found = statusList(plc.plc(), list, 1);
    std::string text;
    for (std::size_t i = 0; i < 20; ++i)
      text += fmt::format("{}{:02X}", i % 2 ? "" : " ", found.data.at(i));
    return text;
  };
  EXPECT_EQ(words(0x0131), " 0001 00F0 000C 0002 DC6C 0000 0000 0000 0000 0000");
  EXPECT_EQ(words(0x0132), " 0001 0001 0001 0000 0000 0000 0000 000A 0000 0014");
  plc.exchange.inUse({3, 1, 2});
  plc.cycles(1);
  EXPECT_EQ(words(0x0132), " 0001 0001 0001 0003 0001 0000 0000 000A 0004 0014");
  plc.exchange.inUse({});
  plc.look();
  EXPECT_EQ(words(0x0132), " 0001 0001 0001 0000 0000 0000 0000 000A 0000 0014");
}

// The interface that clients come by (0037); without one there is no record.
TEST(System, theListsHaveTheInterface) {
  ServedPlc plc = ServedPlc::station();
  EXPECT_EQ(statusList(plc.plc(), 0x0037, 0).records, 0);
  EXPECT_EQ(statusList(plc.plc(), 0x0137, 0x07FE).error, Error::NoInformation);
  plc.exchange.opened();
  plc.exchange.reachedBy(
      system::EthernetInterface{{192, 168, 1, 10}, {255, 255, 255, 0}, {8, 0, 6, 1, 2, 3}});
  plc.cycles(1);
  const auto all = statusList(plc.plc(), 0x0037, 0), one = statusList(plc.plc(), 0x0137, 0x07FE);
  ASSERT_EQ(all.data.size(), 48u);
  EXPECT_EQ(
      Bytes(all.data.begin(), all.data.begin() + 21),
      (Bytes{0x07, 0xFE, 192, 168, 1, 10, 255, 255, 255, 0, 192, 168, 1, 10, 8, 0, 6, 1, 2, 3, 1}));
  EXPECT_EQ(one.data, all.data);
  EXPECT_EQ(statusList(plc.plc(), 0x0137, 0x07FF).error, Error::NoInformation);
  plc.exchange.closed();
}

TEST(System, theClockIsThatOfTheCpu) {
  ServedPlc plc = ServedPlc::station();
  const ClockTime time = {0x24, 0x12, 0x31, 0x23, 0x59, 0x58, 0x12, 0x33};
  EXPECT_EQ(setClock(plc.plc(), time), Error::None);
  EXPECT_EQ(clockOf(plc.plc()), time);
  EXPECT_EQ(setClock(plc.plc(), {0x24, 0x13}), Error::WrongTime);
}

TEST(System, aSinumerikHasNeitherListsNorAClock) {
  ServedPlc plc = ServedPlc::control();
  EXPECT_EQ(statusList(plc.plc(), 0x0011, 0).error, Error::NoSuchList);
  EXPECT_FALSE(clockOf(plc.plc()));
  EXPECT_EQ(setClock(plc.plc(), {}), Error::FunctionNotAvailable);
}

}  // namespace
}  // namespace merker::served
