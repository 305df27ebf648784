// Two CPUs with a configured connection between them: BSEND, BRCV, GET, PUT in virtual time over a
// pipe (S7-SFB-10, S7-NETPRO-08).
#include "served/partners.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "compilation/build.h"
#include "served/exchange.h"
#include "served_plc.h"

namespace merker::served {
namespace {

// M 0.0 REQ, M 0.1 R, M 0.2 EN_R; MB 100 counts DONE, MB 101 NDR, MB 102 ERROR; MW 104 and 106 are
// the last STATUS of BSEND and BRCV other than 0, MW 108 the LEN of what came.
std::string blocks(std::uint32_t rid, int length) {
  return fmt::format(
      "DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY [-32768..32765] OF BYTE;\nEND_STRUCT\nBEGIN\n"
      " a[-32768] := B#16#11; a[-32767] := B#16#22; a[-32766] := B#16#33; a[32231] := "
      "B#16#44;\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 2\nSTRUCT\n a : ARRAY [-32768..32765] OF "
      "BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 12\nSFB 12\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 13\nSFB 13\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 14\nSFB 14\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 15\nSFB 15\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
      " L {1}; T MW 110;\n"
      " CALL SFB 12, DB 12 (REQ := M 0.0, R := M 0.1, ID := W#16#1, R_ID := DW#16#{0},\n"
      "  DONE := M 1.0, ERROR := M 1.1, STATUS := MW 112, SD_1 := P#DB1.DBX 0.0 BYTE 65534,\n"
      "  LEN := MW 110);\n"
      " U M 1.0; SPBN d; L MB 100; + 1; T MB 100; d: U M 1.1; SPBN e; L MB 102; + 1; T MB 102;\n"
      " e: L MW 112; L 0; ==I; SPB n; TAK; T MW 104; n: NOP 0;\n"
      " CALL SFB 13, DB 13 (EN_R := M 0.2, ID := W#16#1, R_ID := DW#16#2,\n"
      "  NDR := M 1.2, ERROR := M 1.3, STATUS := MW 114, RD_1 := P#DB2.DBX 0.0 BYTE 65534,\n"
      "  LEN := MW 116);\n"
      " U M 1.2; SPBN r; L MB 101; + 1; T MB 101; L MW 116; T MW 108;\n"
      " r: U M 1.3; SPBN f; L MB 102; + 1; T MB 102; f: L MW 114; T MW 106;\n"
      " CALL SFB 14, DB 14 (REQ := M 0.3, ID := W#16#1, NDR := M 2.0, ERROR := M 2.1,\n"
      "  STATUS := MW 118, ADDR_1 := P#DB2.DBX 8.0 BYTE 4, ADDR_2 := P#M 50.3 BOOL 1,\n"
      "  RD_1 := P#M 120.0 DWORD 1, RD_2 := P#M 51.5 BOOL 1);\n"
      " CALL SFB 15, DB 15 (REQ := M 0.4, ID := W#16#1, DONE := M 2.2, ERROR := M 2.3,\n"
      "  STATUS := MW 124, ADDR_1 := P#DB2.DBX 8.0 WORD 2, ADDR_2 := P#M 50.3 BOOL 1,\n"
      "  SD_1 := P#M 130.0 BYTE 4, SD_2 := P#M 52.0 BOOL 1);\n"
      " U M 2.0; S M 3.0; U M 2.1; S M 3.1; U M 2.2; S M 3.2; U M 2.3; S M 3.3;\n"
      " U M 2.1; SPBN g; L MW 118; T MW 126; g: U M 2.3; SPBN h; L MW 124; T MW 128; h: NOP 0;\n"
      "END_ORGANIZATION_BLOCK\n",
      rid, length);
}

// A CPU with one connection, W#16#1.
class PartnerPlc {
 public:
  PartnerPlc(const std::string& text, bool active)
      : build_(compilation::build(project::load("a.awl", "generic", {{"a.awl", text}}), false)) {
    for (const Problem& problem : build_.problems.list())
      if (problem.severity() == Severity::Error) ADD_FAILURE() << problem.message;
    build_.project.communication.configured = {{.active = active}};
    plc_ = build_.controller();
    monitor_ = monitor::monitorOf(*plc_, build_.project.symbols, build_.resolver());
    plc_->onCycle([this](controller::Controller&) { exchange.cycleEnded(*monitor_); });
    exchange.partners().configure(build_.project.communication.configured);
    plc_->start();
  }
  PartnerPlc(const PartnerPlc&) = delete;

  controller::Controller& plc() { return *plc_; }
  s7comm::Partner& partner() { return exchange.partners().partner(0); }
  void look() { exchange.look(monitor_.get()); }
  std::uint32_t value(std::uint32_t byte, Width width = Width::Word) {
    return plc_->read(reference(flag(byte, width))).value_or(0xDEAD);
  }
  void set(std::uint32_t byte, std::uint32_t value, Width width = Width::Byte) {
    plc_->write(reference(flag(byte, width)), value);
  }
  bool bit(std::uint32_t byte, unsigned bit) { return (value(byte, Width::Byte) >> bit & 1) != 0; }
  std::uint32_t data(std::uint16_t block, std::uint32_t byte) {
    return plc_->read(reference(fmt::format("DB{}.DBB {}", block, byte))).value_or(0xDEAD);
  }

  Exchange exchange;
  std::deque<s7comm::Bytes> sent;
  std::shared_ptr<s7comm::Session> session;

 private:
  static std::string flag(std::uint32_t byte, Width width) {
    const char* const name = width == Width::DWord ? "MD" : width == Width::Word ? "MW" : "MB";
    return fmt::format("{} {}", name, byte);
  }
  address::Reference reference(const std::string& text) {
    return build_.resolver()(text, {}).value();
  }
  compilation::Build build_;
  std::unique_ptr<controller::Controller> plc_;
  std::unique_ptr<monitor::Monitor> monitor_;
};

class TwoPlcs : public ::testing::Test {
 protected:
  explicit TwoPlcs(int length = 300, std::uint32_t rid = 2)
      : calling(blocks(rid, length), true), called(blocks(rid, length), false) {
    connect();
  }
  void connect() {
    for (PartnerPlc* one : {&calling, &called}) {
      one->partner().attach([one](s7comm::Bytes pdu) { one->sent.push_back(std::move(pdu)); });
      one->exchange.opened();
      one->session = std::make_shared<s7comm::Session>(
          one->exchange, [one](s7comm::Bytes pdu) { one->sent.push_back(std::move(pdu)); });
    }
    calling.partner().setUp({});
    move();
    cycles(1);
  }
  void cut() {
    for (PartnerPlc* one : {&calling, &called}) {
      one->partner().detach();
      one->sent.clear();
      one->session->end();
      one->exchange.closed();
    }
  }
  void move(std::size_t most = 10'000) {
    for (; most > 0 && !(calling.sent.empty() && called.sent.empty()); --most)
      calling.sent.empty() ? pass(called, calling) : pass(calling, called);
  }
  void pass(PartnerPlc& from, PartnerPlc& to) {
    const s7comm::Bytes pdu = std::move(from.sent.front());
    from.sent.pop_front();
    if (to.partner().receive(pdu) == s7comm::Partner::Heard::NotMine) {
      ASSERT_TRUE(to.session->receive(pdu));
    }
    if (to.session->isSetUp() && !to.partner().isConnected())
      to.partner().agreed(to.session->pdu());
  }
  // Of both, with so many PDUs after each.
  void cycles(int count, std::size_t pdus = 10'000) {
    for (; count > 0; --count) {
      for (PartnerPlc* one : {&calling, &called}) one->plc().advanceCycles(1);
      move(pdus);
    }
  }

  PartnerPlc calling, called;
};

TEST_F(TwoPlcs, ATelegramTakesThreeCycles) {
  called.set(0, 0x04);  // EN_R
  cycles(2);
  EXPECT_EQ(called.value(106), 25u);
  calling.set(0, 0x01);
  cycles(1);
  EXPECT_EQ(calling.value(104), 25u);
  EXPECT_EQ(calling.value(100, Width::Byte), 0u);
  EXPECT_EQ(called.value(101, Width::Byte), 0u);
  cycles(1);  // it was sent and acknowledged behind the cycle before, and is known at the end of
              // this one
  EXPECT_EQ(calling.value(100, Width::Byte), 0u);
  cycles(1);
  EXPECT_EQ(calling.value(100, Width::Byte), 1u);
  EXPECT_EQ(called.value(101, Width::Byte), 1u);
  EXPECT_EQ(called.value(108), 300u);
  EXPECT_EQ(called.data(2, 0), 0x11u);
  EXPECT_EQ(called.data(2, 2), 0x33u);
  cycles(20);  // REQ has no other edge
  EXPECT_EQ(calling.value(100, Width::Byte), 1u);
  EXPECT_EQ(called.value(101, Width::Byte), 1u);
  EXPECT_EQ(calling.value(102, Width::Byte) + called.value(102, Width::Byte), 0u);
}

TEST_F(TwoPlcs, TheSameEveryTime) {
  const auto instants = [] {
    struct Run : TwoPlcs {
      void TestBody() override {}
      std::string run() {
        std::string told;
        called.set(0, 0x04);
        for (unsigned i = 0; i < 60; ++i) {
          calling.set(0, i % 10 < 5 ? 1 : 0);
          cycles(1, 1);
          told += fmt::format("{} {} {} {} {}\n", calling.value(112), calling.value(100),
                              called.value(114), called.value(116), called.plc().now().ns);
        }
        return told;
      }
    };
    return Run().run();
  };
  const std::string first = instants();
  EXPECT_NE(first.find(" 17 "), std::string::npos) << first;  // bytes that come, one by one
  EXPECT_EQ(first, instants());
}

// STATUS 11, 25 and 5; the next job begins with the next edge.
TEST_F(TwoPlcs, RunningJobsAndR) {
  called.set(0, 0x04);
  cycles(2);
  calling.set(0, 0x01);
  cycles(2, 1);  // slow
  calling.set(0, 0x00);
  cycles(1, 0);
  EXPECT_EQ(calling.value(112), 25u);
  calling.set(0, 0x01);
  cycles(1, 0);
  EXPECT_EQ(calling.value(112), 11u);
  calling.set(0, 0x03);  // R
  cycles(3, 0);
  EXPECT_EQ(calling.value(102, Width::Byte), 1u);
  EXPECT_EQ(calling.value(104), 5u);
  calling.set(0, 0x00);
  cycles(2);
  calling.set(0, 0x01);
  cycles(4);
  EXPECT_EQ(calling.value(100, Width::Byte), 1u);
}

// EN_R = 0: STATUS 6; nobody has taken it yet: 7; no connection: 1.
TEST_F(TwoPlcs, WhatTheReceiverSays) {
  const auto statusOf = [&] {
    calling.set(0, 0x00);
    cycles(1);
    calling.set(0, 0x01);
    cycles(4);
    return calling.value(104);
  };
  EXPECT_EQ(statusOf(), 3u);
  called.set(0, 0x04);
  cycles(2);
  called.set(0, 0x00);
  cycles(2);
  EXPECT_EQ(statusOf(), 6u);
  cut();
  EXPECT_EQ(statusOf(), 1u);
  called.set(0, 0x04);
  cycles(2);
  EXPECT_EQ(called.value(106), 1u);
  connect();
  cycles(2);
  EXPECT_EQ(called.value(106), 25u);
  calling.set(100, 0);
  statusOf();
  EXPECT_EQ(calling.value(100, Width::Byte), 1u);
}

// A restart of the receiver forgets what had begun, and the program begins anew.
TEST_F(TwoPlcs, ARestartBeginsAnew) {
  called.set(0, 0x04);
  cycles(2);
  calling.set(0, 0x01);
  cycles(2, 1);
  called.plc().stop();
  called.look();
  called.plc().start();
  called.set(0, 0x04);
  cycles(8);
  EXPECT_EQ(calling.value(100, Width::Byte), 0u);
  EXPECT_EQ(calling.value(102, Width::Byte), 1u);
  calling.set(0, 0x00);
  cycles(1);
  calling.set(0, 0x01);
  cycles(5);
  EXPECT_EQ(calling.value(100, Width::Byte), 1u);
}

TEST_F(TwoPlcs, GetAndPut) {
  calling.set(130, 0xA1B2C3D4, Width::DWord);
  calling.set(52, 0x01);
  called.set(50, 0x00);
  calling.set(0, 0x10);
  cycles(4);
  EXPECT_TRUE(calling.bit(3, 2));
  EXPECT_EQ(called.data(2, 8), 0xA1u);
  EXPECT_EQ(called.data(2, 11), 0xD4u);
  EXPECT_EQ(called.value(50, Width::Byte), 0x08u);
  calling.set(0, 0x08);
  cycles(4);
  EXPECT_TRUE(calling.bit(3, 0));
  EXPECT_EQ(calling.value(120, Width::DWord), 0xA1B2C3D4u);
  EXPECT_EQ(calling.value(51, Width::Byte), 0x20u);
  EXPECT_FALSE(calling.bit(3, 1));
  EXPECT_FALSE(calling.bit(3, 3));
}

struct LongOnes : TwoPlcs {
  LongOnes() : TwoPlcs(0, 2) {}
};
// 1 and 65,534 bytes, and LEN that is no length.
TEST_F(LongOnes, Lengths) {
  calling.set(0, 0x01);
  cycles(2);
  EXPECT_EQ(calling.value(104), 4u);
}
struct WholeBlock : TwoPlcs {
  WholeBlock() : TwoPlcs(-536, 2) {}  // 65,000 as an INT
};
TEST_F(WholeBlock, MoreThan64000Bytes) {
  called.set(0, 0x04);
  cycles(2);
  calling.set(0, 0x01);
  cycles(4);
  EXPECT_EQ(called.value(108), 65'000u);
  EXPECT_EQ(called.data(2, 64'999), 0x44u);
}

}  // namespace
}  // namespace merker::served
