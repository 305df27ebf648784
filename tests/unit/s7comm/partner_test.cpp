// Two partners of a connection, PDU by PDU (S7-SFB-10).
#include "s7comm/partner.h"

#include <gtest/gtest.h>

#include <numeric>

#include "../hex.h"
#include "line.h"

namespace merker::s7comm {
namespace {

using Results = std::vector<std::pair<std::uint32_t, PartnerStatus>>;

// What a program is told.
struct Told : PartnerProgram {
  void connected(bool is) override { connections.push_back(is); }
  void finished(PartnerResult result) override {
    results.emplace_back(result.number, result.status);
    for (Bytes& value : result.values) values.push_back(std::move(value));
  }
  void begun(std::uint32_t, std::size_t count) override { octets = count; }
  void arrived(Telegram telegram) override { telegrams.push_back(std::move(telegram)); }

  void noticed(Notice notice) override { notices.push_back(std::move(notice)); }

  std::vector<bool> connections;
  Results results;
  std::vector<Bytes> values;
  std::size_t octets = 0;
  std::vector<Telegram> telegrams;
  std::vector<Notice> notices;
};

struct End {
  Told told;
  Partner partner{told};
  std::deque<Bytes> sent;
};

// The calling side, and the one that is called with a server beside its partner.
class PartnerLine : public ::testing::Test {
 protected:
  void connect(std::uint16_t pdu = 240) {
    calling.partner.attach([this](Bytes bytes) { calling.sent.push_back(std::move(bytes)); });
    called.partner.attach([this](Bytes bytes) { called.sent.push_back(std::move(bytes)); });
    session = std::make_shared<Session>(
        plc, [this](Bytes bytes) { called.sent.push_back(std::move(bytes)); }, Offer{.pdu = pdu});
    calling.partner.setUp({.pdu = 480});
    move();
  }
  void cut() {
    calling.partner.detach();
    called.partner.detach();
    calling.sent.clear();
    called.sent.clear();
  }
  // At most so many PDUs.
  void move(std::size_t most = 10'000) {
    for (; most > 0 && !(calling.sent.empty() && called.sent.empty()); --most) {
      const bool to = !calling.sent.empty();
      End& from = to ? calling : called;
      const Bytes pdu = std::move(from.sent.front());
      from.sent.pop_front();
      pdus.push_back(pdu.size());
      to ? hearCalled(pdu) : hearCalling(pdu);
    }
  }
  void hearCalled(const Bytes& pdu) {
    const auto heard = called.partner.receive(pdu);
    ASSERT_NE(heard, Partner::Heard::Wrong);
    if (heard == Partner::Heard::NotMine) {
      ASSERT_TRUE(session->receive(pdu));
    }
    if (session->isSetUp() && !called.partner.isConnected()) called.partner.agreed(session->pdu());
  }
  void hearCalling(const Bytes& pdu) {
    ASSERT_EQ(calling.partner.receive(pdu), Partner::Heard::Done);
  }
  static ToPartner telegram(std::uint32_t number, std::size_t octets, std::uint32_t rid = 5) {
    Bytes bytes(octets);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
    return {.jobs = {{.number = number, .rid = rid, .values = {std::move(bytes)}}}};
  }
  static ToPartner receiver(bool enabled, std::uint32_t rid = 5) {
    return {.receivers = {{rid, enabled}}};
  }

  FewBytes plc;
  End calling, called;
  std::shared_ptr<Session> session;
  std::vector<std::size_t> pdus;
};

TEST_F(PartnerLine, AgreesOnThePdu) {
  connect();
  EXPECT_EQ(calling.partner.pdu(), 240);
  EXPECT_EQ(calling.told.connections, std::vector<bool>{true});
  EXPECT_EQ(called.told.connections, std::vector<bool>{true});
  EXPECT_FALSE(calling.partner.asks());
}

TEST_F(PartnerLine, AnAnswerOffersNoMoreThanWasAskedFor) {
  calling.partner.attach([this](Bytes bytes) { calling.sent.push_back(std::move(bytes)); });
  calling.partner.setUp({.pdu = 240});
  const Bytes& asked = calling.sent.front();
  const Bytes answer = {0x32, 3, 0,    0, asked[4], asked[5], 0, 8, 0,    0,
                        0,    0, 0xF0, 0, 0,        1,        0, 1, 0xFF, 0xFF};
  EXPECT_EQ(calling.partner.receive(answer), Partner::Heard::Done);
  EXPECT_EQ(calling.partner.pdu(), 240);
}

TEST_F(PartnerLine, TelegramsOfEveryLength) {
  connect();
  for (const std::size_t octets : {1u, 203u, 204u, 205u, 206u, 480u, 65'000u, 65'534u}) {
    called.partner.order(receiver(true));
    calling.partner.order(telegram(1, octets));
    move();
    ASSERT_EQ(calling.told.results, (Results{{1, PartnerStatus::Done}})) << octets;
    ASSERT_EQ(called.told.telegrams.size(), 1u) << octets;
    EXPECT_EQ(called.told.telegrams[0].octets, telegram(1, octets).jobs[0].values[0]) << octets;
    calling.told.results.clear();
    called.told.telegrams.clear();
  }
  EXPECT_EQ(*std::max_element(pdus.begin(), pdus.end()), 240u);
}

// Both ways at the same time: each side answers while it waits for an answer.
TEST_F(PartnerLine, BothSendAtTheSameTime) {
  connect();
  calling.partner.order(receiver(true, 9));
  called.partner.order(receiver(true));
  calling.partner.order(telegram(1, 1000));
  called.partner.order(telegram(2, 1000, 9));
  move();
  EXPECT_EQ(calling.told.results, (Results{{1, PartnerStatus::Done}}));
  EXPECT_EQ(called.told.results, (Results{{2, PartnerStatus::Done}}));
  EXPECT_EQ(calling.told.telegrams.size(), 1u);
  EXPECT_EQ(called.told.telegrams.size(), 1u);
}

// STATUS 3, 6 and 7 of BSEND.
TEST_F(PartnerLine, TheStateOfTheReceiverDecides) {
  connect();
  calling.partner.order(telegram(1, 300));
  move();
  called.partner.order(receiver(false));
  calling.partner.order(telegram(2, 300));
  move();
  called.partner.order(receiver(true));
  calling.partner.order(telegram(3, 300));
  calling.partner.order(telegram(4, 300));  // the program has not taken the other one
  move();
  EXPECT_EQ(calling.told.results, (Results{{1, PartnerStatus::UnknownReceiver},
                                           {2, PartnerStatus::Disabled},
                                           {3, PartnerStatus::Done},
                                           {4, PartnerStatus::NotReady}}));
  EXPECT_EQ(called.told.telegrams.size(), 1u);
}

// STATUS 2 of BSEND, 4 of BRCV: RD_1 is shorter than what comes. It is told once, and the next one
// fits.
TEST_F(PartnerLine, ATelegramThatIsTooLongIsRefused) {
  connect();
  ToPartner small = receiver(true);
  small.receivers[0].octets = 300;
  called.partner.order(small);
  calling.partner.order(telegram(1, 301));
  move();
  EXPECT_EQ(calling.told.results, (Results{{1, PartnerStatus::Refused}}));
  ASSERT_EQ(called.told.telegrams.size(), 1u);
  EXPECT_TRUE(called.told.telegrams[0].tooLong);
  EXPECT_TRUE(called.told.telegrams[0].octets.empty());
  called.partner.order(small);
  calling.partner.order(telegram(2, 300));
  move();
  EXPECT_EQ(calling.told.results.back().second, PartnerStatus::Done);
  EXPECT_EQ(called.told.telegrams.back().octets.size(), 300u);
}

TEST_F(PartnerLine, LostInTheMiddleAndBuiltAgain) {
  connect();
  called.partner.order(receiver(true));
  calling.partner.order(telegram(1, 1000));
  calling.partner.order(telegram(2, 10));
  move(5);
  EXPECT_GT(called.told.octets, 0u);
  cut();
  EXPECT_EQ(calling.told.results,
            (Results{{1, PartnerStatus::NoConnection}, {2, PartnerStatus::NoConnection}}));
  EXPECT_EQ(calling.told.connections, (std::vector<bool>{true, false}));
  calling.partner.order(telegram(3, 10));
  EXPECT_EQ(calling.told.results.back(), (std::pair{3u, PartnerStatus::NoConnection}));
  connect();
  calling.partner.order(telegram(4, 1000));
  move();
  EXPECT_EQ(calling.told.results.back(), (std::pair{4u, PartnerStatus::Done}));
  ASSERT_EQ(called.told.telegrams.size(), 1u);
  EXPECT_EQ(called.told.telegrams[0].octets.size(), 1000u);
}

// R ends what runs behind its segment, and what waits at once; the next one begins anew.
TEST_F(PartnerLine, AbortedByR) {
  connect();
  called.partner.order(receiver(true));
  calling.partner.order(telegram(1, 1000));
  calling.partner.order(telegram(2, 1000));
  calling.partner.order(telegram(3, 300));
  move(3);
  calling.partner.order({.aborted = {1, 2}});
  EXPECT_EQ(calling.told.results, (Results{{1, PartnerStatus::Reset}, {2, PartnerStatus::Reset}}));
  move();
  EXPECT_EQ(calling.told.results.size(), 3u);
  EXPECT_EQ(calling.told.results.back(), (std::pair{3u, PartnerStatus::Done}));
  ASSERT_EQ(called.told.telegrams.size(), 1u);
  EXPECT_EQ(called.told.telegrams[0].octets.size(), 300u);
}

TEST_F(PartnerLine, ARestartForgetsJobsAndReceivers) {
  connect();
  called.partner.order(receiver(true));
  calling.partner.order(telegram(1, 1000));
  move(2);
  calling.partner.order({.restart = true});
  called.partner.order({.restart = true});
  move();
  calling.partner.order(telegram(2, 10));
  move();
  EXPECT_EQ(calling.told.results, (Results{{2, PartnerStatus::UnknownReceiver}}));
  EXPECT_TRUE(called.told.telegrams.empty());
}

TEST_F(PartnerLine, AReceiverThatHasGoneMakesRoom) {
  connect();
  for (std::uint32_t rid = 0; rid < 2 * BlockReceivers::kMost; ++rid) {
    called.partner.order(receiver(true, rid));
    calling.partner.order(telegram(rid, 1, rid));
    move();
    called.partner.order({.receivers = {{.rid = rid, .removed = true}}});
  }
  EXPECT_EQ(called.told.telegrams.size(), 2 * BlockReceivers::kMost);
  for (std::uint32_t rid = 0; rid <= BlockReceivers::kMost; ++rid)
    called.partner.order(receiver(true, rid));
  calling.partner.order(telegram(1, 1, BlockReceivers::kMost));
  move();
  EXPECT_EQ(calling.told.results.back().second, PartnerStatus::UnknownReceiver);
}

TEST_F(PartnerLine, GetAndPut) {
  connect();
  const AnyItem word{.type = ElementType::Byte,
                     .count = 2,
                     .block = 1,
                     .memory = Memory::DataBlock,
                     .address = 4 * 8};
  const AnyItem bit{.type = ElementType::Bit, .memory = Memory::Flag, .address = 3};
  calling.partner.order({.jobs = {{.kind = PartnerJob::Kind::Put,
                                   .number = 1,
                                   .items = {word, bit},
                                   .values = {{0xAB, 0xCD}, {1}}}}});
  calling.partner.order({.jobs = {{.kind = PartnerJob::Kind::Get, .number = 2, .items = {word}}}});
  move();
  EXPECT_EQ(calling.told.results, (Results{{1, PartnerStatus::Done}, {2, PartnerStatus::Done}}));
  ASSERT_EQ(calling.told.values.size(), 1u);
  EXPECT_EQ(toHex(calling.told.values[0]), "AB CD");
}

TEST_F(PartnerLine, GetAndPutThatFail) {
  connect();
  const AnyItem missing{.block = 77, .memory = Memory::DataBlock};
  const AnyItem large{.count = 300, .block = 1, .memory = Memory::DataBlock};
  calling.partner.order(
      {.jobs = {{.kind = PartnerJob::Kind::Get, .number = 1, .items = {missing}}}});
  calling.partner.order({.jobs = {{.kind = PartnerJob::Kind::Get, .number = 2, .items = {large}}}});
  calling.partner.order({.jobs = {{.kind = PartnerJob::Kind::Put,
                                   .number = 3,
                                   .items = {large},
                                   .values = {Bytes(300)}}}});
  move();
  EXPECT_EQ(calling.told.results, (Results{{1, PartnerStatus::NoAccess},
                                           {2, PartnerStatus::Refused},
                                           {3, PartnerStatus::WrongLength}}));
}

// Segments out of their order, longer than they said, with a length of 0.
TEST_F(PartnerLine, WrongSegmentsAreRefused) {
  connect();
  called.partner.order(receiver(true));
  const Bytes octets(20);
  const auto answerTo = [&](const Segment& segment) {
    called.partner.receive(writeSegment(1, segment));
    const Bytes answer = std::exchange(called.sent, {}).at(0);
    return readSegmentAnswer(*readPdu(answer))->error;
  };
  EXPECT_EQ(answerTo({.rid = 5, .sequence = 1, .octets = octets}), Error::WrongSequence);
  EXPECT_EQ(answerTo({.rid = 5, .total = 19, .octets = octets}), Error::WrongPduSize);
  EXPECT_EQ(answerTo({.rid = 5, .total = 0, .octets = octets}), Error::WrongPduSize);
  EXPECT_EQ(answerTo({.rid = 5, .total = 21, .octets = octets}), Error::WrongPduSize);
  EXPECT_EQ(answerTo({.rid = 5, .last = false, .total = 0xFFFF, .octets = octets}),
            Error::WrongPduSize);
  EXPECT_EQ(answerTo({.rid = 5, .last = false, .total = 30, .octets = octets}), Error::None);
  EXPECT_EQ(answerTo({.rid = 5, .sequence = 77, .octets = octets}), Error::WrongSequence);
  EXPECT_TRUE(called.told.telegrams.empty());
}

TEST_F(PartnerLine, NoMoreJobsThanItTakes) {
  connect();
  ToPartner many;
  for (std::uint32_t i = 0; i < Partner::kMostJobs + 2; ++i)
    many.jobs.push_back({.number = i, .rid = 5, .values = {Bytes(1)}});
  calling.partner.order(std::move(many));
  EXPECT_EQ(calling.told.results, (Results{{Partner::kMostJobs + 1, PartnerStatus::TooManyJobs},
                                           {Partner::kMostJobs, PartnerStatus::TooManyJobs}}));
}

// USEND: nobody answers, so that it is done when it is sent, whoever listens.
TEST_F(PartnerLine, ANoticeIsDoneWhenItIsSent) {
  connect();
  const auto send = [&](std::uint32_t number, std::size_t octets) {
    calling.partner.order({.jobs = {{.kind = PartnerJob::Kind::Send,
                                     .number = number,
                                     .rid = 5,
                                     .areas = {{DataUnit::Byte, Bytes(octets, 7)}}}}});
    move();
  };
  const auto listen = [&](bool enabled) {
    called.partner.order({.receivers = {{.rid = 5, .enabled = enabled, .blocks = false}}});
  };
  send(1, 4);
  EXPECT_EQ(called.told.notices.size(), 0u);
  called.partner.order(receiver(true));  // a BRCV of this R_ID is another block
  send(2, 4);
  EXPECT_EQ(called.told.notices.size(), 0u);
  listen(true);
  send(3, 212);
  send(4, 213);  // does not fit a PDU of 240 bytes
  listen(false);
  send(5, 4);
  ASSERT_EQ(called.told.notices.size(), 1u);
  EXPECT_EQ(called.told.notices[0].areas.at(0).octets, Bytes(212, 7));
  EXPECT_EQ(calling.told.results, (Results{{1, PartnerStatus::Done},
                                           {2, PartnerStatus::Done},
                                           {3, PartnerStatus::Done},
                                           {4, PartnerStatus::WrongLength},
                                           {5, PartnerStatus::Done}}));
  EXPECT_FALSE(calling.partner.asks());
}

}  // namespace
}  // namespace merker::s7comm
