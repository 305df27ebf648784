// The serial line in the workbench: characters with their meaning, the partner, the outside.
#include "scenario/steps/serial.h"

#include "bench.h"

namespace merker::workbench::test {
namespace {

constexpr const char* kSerial =
    "[cpu]\nmodel = \"314C-2 PtP\"\n\n[[module]]\nslot = \"2.1\"\n[module.serial]\n";

class Line : public ::testing::Test {
 protected:
  explicit Line(const std::string& settings = "protocol = \"3964R\"\npriority = \"low\"\n")
      : bench(kProgram, kSerial + settings) {}

  void perform(const std::string& step) { bench.call("serial.do", {{"step", step}}); }
  // Two looks lie 200 ms apart.
  Json event(Workbench::BrowserId who = 1) {
    for (int frame = 0; frame < 8; ++frame)
      if (const Json one = bench.event("serial", who); !one.is_null()) return one;
    return nullptr;
  }
  static std::string meanings(const Json& event) {
    std::string all;
    for (const Json& row : event["rows"])
      all +=
          row[2].get<std::string>() + (row[3] == "" ? "" : ": " + row[3].get<std::string>()) + "\n";
    return all;
  }

  Bench bench;
};

// PTP-LINE-11: both directions, with times, names and the block they belong to.
TEST_F(Line, EachCharacterHasItsTimeAndMeaning) {
  EXPECT_EQ(bench.call("serial.watch", {{"on", true}})["line"]["protocol"], "3964R");
  perform("partner 3964R");
  perform("send \"A\"");
  bench.run(Duration::seconds(1));
  const Json seen = event();
  EXPECT_EQ(meanings(seen),
            "NAK: ready\nNAK: ready\nSTX: wants to send\nDLE: connection is there\n'A'\nDLE\nETX: "
            "end of the "
            "block\n'R': BCC right; 1 byte\nDLE: block acknowledged\n");
  EXPECT_EQ(seen["first"], 0);
  EXPECT_EQ(seen["line"]["seen"], 9);
  EXPECT_EQ(seen["rows"][2][0], 1);  // the partner
  EXPECT_EQ(seen["rows"][3][0], 0);  // X27
  EXPECT_EQ(seen["rows"][2][5].get<std::int64_t>() - seen["rows"][2][4].get<std::int64_t>(),
            1'145'833);  // 11 bits at 9600 baud
}

TEST_F(Line, OnlyWhatIsNewIsTold) {
  bench.call("serial.watch", {{"on", true}});
  perform("send STX");
  bench.run(Duration::milliseconds(10));
  const std::size_t first = event()["rows"].size();
  EXPECT_TRUE(event().is_null());
  perform("send NAK");
  bench.run(Duration::milliseconds(10));
  const Json next = event();
  EXPECT_EQ(next["first"], first);
  EXPECT_EQ(next["rows"][0][2], "NAK");
  bench.call("serial.watch", {{"on", false}});
  perform("send STX");
  bench.run(Duration::milliseconds(10));
  EXPECT_TRUE(event().is_null());
}

TEST_F(Line, ASecondBrowserSeesWhatWasThere) {
  bench.call("serial.watch", {{"on", true}});
  perform("send 05");
  bench.run(Duration::milliseconds(10));
  const Json first = event();
  bench.workbench.opened(2);
  bench.call("serial.watch", {{"on", true}}, 2);
  EXPECT_EQ(event(2)["rows"], first["rows"]);
}

// Of a long time the last characters are told, in portions.
TEST_F(Line, ABusyLineIsBounded) {
  bench.call("serial.watch", {{"on", true}});
  perform("send 55*6000");
  bench.run(Duration::seconds(8));
  Json one = event();
  EXPECT_EQ(one["rows"].size(), SerialView::kMostTold);
  const std::uint64_t first = one["first"], seen = one["line"]["seen"];
  EXPECT_EQ(seen - first, SerialView::kMostRows);
  std::uint64_t told = 0;
  for (; !one.is_null(); one = event()) {
    EXPECT_EQ(one["first"].get<std::uint64_t>(), first + told);
    told += one["rows"].size();
  }
  EXPECT_EQ(told, SerialView::kMostRows);
}

TEST_F(Line, WhatCannotBeSentIsRefused) {
  const auto text = [&](const char* step) {
    const Json answer = bench.ask("serial.do", {{"step", step}});
    return answer["problems"][0]["code"].get<std::string>();
  };
  EXPECT_EQ(text("send 1"), "P0994");
  EXPECT_EQ(text("shout \"A\""), "P0952");
  EXPECT_EQ(text("job fetch DB10.DBB0 count 2"), "P1308");  // the partner speaks characters
}

// PTP-LINE-12: what is connected to the outside has no partner of its own.
TEST_F(Line, TheOutsideIsShownAndAnswersItself) {
  bench.workbench.serialBy([] { return SerialOutside{"listen:4000", "127.0.0.1:4000", true, ""}; });
  const Json line = bench.call("serial.watch", {{"on", true}})["line"];
  EXPECT_EQ(line["connection"], "listen:4000");
  EXPECT_EQ(line["connected"], true);
  EXPECT_EQ(bench.problem("serial.do", {{"step", "partner 3964R"}}), "P1308");
  perform("send \"A\"");
}

TEST(SerialLine, AnotherProjectBeginsAnew) {
  Bench bench(kProgram, kSerial);
  EXPECT_TRUE(bench.state()["project"]["serial"]);
  bench.call("serial.watch", {{"on", true}});
  bench.call("serial.do", {{"step", "send 01 02 03"}});
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(bench.event("serial")["rows"].size(), 3U);
  bench.workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(bench.folder.path(), {}), false)));
  bench.run(Duration::milliseconds(10));
  bench.call("serial.do", {{"step", "send 04"}});
  bench.run(Duration::milliseconds(20));
  Json fresh;
  for (int frame = 0; frame < 8 && fresh["rows"].empty(); ++frame) fresh = bench.event("serial");
  EXPECT_EQ(fresh["first"], 0);
  EXPECT_EQ(fresh["rows"][0][2], "EOT");
}

TEST(SerialLine, WithoutInterfaceThereIsNoLine) {
  Bench bench;
  EXPECT_FALSE(bench.state()["project"]["serial"]);
  EXPECT_EQ(bench.call("serial.watch", {{"on", true}})["line"], nullptr);
  EXPECT_EQ(bench.problem("serial.do", {{"step", "send 01"}}), "P0993");
}

}  // namespace
}  // namespace merker::workbench::test
