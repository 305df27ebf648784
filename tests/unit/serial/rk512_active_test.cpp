// SEND and FETCH with RK 512, byte by byte (PTP-VEC-22 to -52, -60).
#include "links.h"

namespace merker::serial {
namespace {

// The partner takes this command and answers well.
void sends(const LinkJob& job, const Bytes& data, std::string_view command) {
  LinkedScript s;
  s.answers(command, "00 00 00 00 10 03 13");
  s.begin(job, data);
  s.run(200);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.cpu.end(), "0000");
}

std::string fetches(const LinkJob& job, std::string_view command, std::string_view reaction) {
  LinkedScript s;
  s.answers(command, reaction);
  s.begin(job);
  s.run(200);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.cpu.end(), "0000");
  return text(s.cpu.target);
}

std::string both(const Bytes& data) { return text(data) + " "; }

// PTP-VEC-22, PTP-RK512-01, PTP-RK512-03, PTP-RK512-04, PTP-RK512-05, PTP-RK512-06, PTP-RK512-09,
// PTP-RK512-13
TEST(LinkActive, Send) {
  sends(sendJob(10, 0, 4), hex("01 02 03 04"),
        "00 00 41 44 0A 00 00 02 FF 1F 01 02 03 04 10 03 FA");
}

// PTP-VEC-23, PTP-VEC-24, PTP-VEC-25, PTP-RK512-10, PTP-RK512-11
TEST(LinkActive, FlagAndCpuNumber) {
  LinkJob job = sendJob(101, 0, 2);
  job.flag = {100, 6};
  job.cpu = 0;
  sends(job, hex("11 22"), "00 00 41 44 65 00 00 01 64 06 11 22 10 03 23");
  job.cpu = 1;
  sends(job, hex("11 22"), "00 00 41 44 65 00 00 01 64 16 11 22 10 03 33");
  job = sendJob(10, 0, 2);
  job.cpu = 0;
  sends(job, hex("11 22"), "00 00 41 44 0A 00 00 01 FF FF 11 22 10 03 2E");
}

// PTP-VEC-26, PTP-VEC-27, PTP-VEC-28, PTP-RK512-07, PTP-RK512-17, PTP-RK512-21, PTP-OPEN-03,
// SFB63-10
TEST(LinkActive, OddLengthOddOffsetExtendedBlock) {
  sends(sendJob(10, 0, 3), hex("01 02 03"), "00 00 41 44 0A 00 00 02 FF 1F 01 02 03 00 10 03 FE");
  sends(sendJob(10, 7, 2), hex("AA BB"), "00 00 41 44 0A 03 00 01 FF 1F AA BB 10 03 EF");
  LinkJob job = sendJob(5, 510, 2);
  job.type = 'X';
  sends(job, hex("AA BB"), "00 00 4F 44 05 FF 00 01 FF 1F AA BB 10 03 12");
}

// PTP-VEC-29
TEST(LinkActive, DleInTheHeaderIsDoubled) {
  Bytes data = counting(64);
  data.erase(data.begin(), data.begin() + 32);
  sends(sendJob(16, 32, 32), data,
        "00 00 41 44 10 10 10 10 00 10 10 FF 1F 20 21 22 23 24 25 26 27 28 29 2A 2B 2C 2D 2E 2F "
        "30 31 32 33 34 35 36 37 38 39 3A 3B 3C 3D 3E 3F 10 03 F6");
}

// PTP-VEC-30, PTP-RK512-12, PTP-RK512-15
TEST(LinkActive, SendWithAFollowOnTelegram) {
  LinkedScript s;
  Bytes first = counting(128);
  first.insert(first.begin() + 17, 0x10);  // doubled
  s.answers("00 00 41 44 14 00 00 41 FF 1F " + both(first) + "10 03 B3", "00 00 00 00 10 03 13");
  s.answers("FF 00 41 44 80 81 10 03 E8", "FF 00 00 00 10 03 EC");
  s.begin(sendJob(20, 0, 130), counting(130));
  s.run(600);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.cpu.end(), "0000");
}

// PTP-RK512-15, PTP-RK512-16
TEST(LinkActive, NumberOfTelegramsAndCharacters) {
  const std::pair<std::uint16_t, std::size_t> rows[] = {{128, 1}, {130, 2}, {1000, 8}, {1024, 8}};
  for (const auto& [length, telegrams] : rows) {
    LinkCpu a, b(false);
    Coupled lines(a.driver, b.driver);
    b.memory.db(20).resize(1024);
    a.begin(sendJob(20, 0, length), Bytes(length, 0x55), lines.now);
    cycles(lines, {&a, &b}, 2'500);
    EXPECT_EQ(a.end(), "0000");
    std::size_t doubled = 0;
    for (const Sighting& s : lines.seen) doubled += s.value == 0x10 ? 1U : 0U;
    EXPECT_EQ(doubled, telegrams * 6);  // three in each block of two, none of them data
    EXPECT_EQ(lines.seen.size(), length + telegrams * (6 + 4 + 10) + 6);
    if (length == 1000) {
      EXPECT_EQ(lines.seen.size(), 1166U);
    }
    EXPECT_EQ(Bytes(b.memory.db(20).begin(), b.memory.db(20).begin() + length),
              Bytes(length, 0x55));
  }
}

// PTP-VEC-31, PTP-RK512-22, PTP-RK512-34
TEST(LinkActive, Fetch) {
  EXPECT_EQ(fetches(fetchJob('D', 10, 4, 4), "00 00 45 44 0A 02 00 02 FF 1F 10 03 F8",
                    "00 00 00 00 AA BB CC DD 10 03 13"),
            "AA BB CC DD");
}

// PTP-VEC-32, PTP-VEC-33, PTP-VEC-34, PTP-VEC-35, PTP-VEC-36, PTP-VEC-37, PTP-RK512-08,
// PTP-RK512-19, PTP-RK512-22
TEST(LinkActive, FetchOfEachType) {
  EXPECT_EQ(fetches(fetchJob('M', 0, 100, 5), "00 00 45 4D 00 64 00 05 FF 1F 10 03 9A",
                    "00 00 00 00 01 02 03 04 05 10 03 12"),
            "01 02 03 04 05");
  fetches(fetchJob('E', 0, 0, 2), "00 00 45 45 00 00 00 02 FF 1F 10 03 F1",
          "00 00 00 00 AA BB 10 03 02");
  fetches(fetchJob('A', 0, 4, 1), "00 00 45 41 00 04 00 01 FF 1F 10 03 F2",
          "00 00 00 00 AA 10 03 B9");
  fetches(fetchJob('Z', 0, 1, 20), "00 00 45 5A 00 01 00 0A FF 1F 10 03 E7",
          "00 00 00 00 " + both(Bytes(20, 0x25)) + "10 03 13");
  fetches(fetchJob('T', 0, 16, 4), "00 00 45 54 00 10 10 00 02 FF 1F 10 03 E0",
          "00 00 00 00 01 02 03 04 10 03 17");
  fetches(fetchJob('X', 7, 0, 2), "00 00 45 58 07 00 00 01 FF 1F 10 03 E8",
          "00 00 00 00 AA BB 10 03 02");
}

// PTP-VEC-38, PTP-RK512-14, PTP-RK512-24
TEST(LinkActive, FetchWithFollowOnTelegrams) {
  LinkCpu a, b(false);
  Coupled lines(a.driver, b.driver);
  b.memory.db(30) = Bytes(300, 0x55);
  LinkJob job = fetchJob('D', 30, 0, 300);
  job.flag = {10, 3};
  a.begin(job, {}, lines.now);
  cycles(lines, {&a, &b}, 1'000);
  const std::string trace = lines.trace();
  const auto count = [&](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = trace.find(part); at != std::string::npos; at = trace.find(part, at + 1))
      ++found;
    return found;
  };
  EXPECT_EQ(count("A 00 00 45 44 1E 00 00 96 0A 13 10 03 83"), 1U);
  EXPECT_EQ(count("A FF 00 45 44 10 03 ED"), 2U);
  EXPECT_EQ(count("B 00 00 00 00 " + both(Bytes(128, 0x55)) + "10 03 13"), 1U);
  EXPECT_EQ(count("B FF 00 00 00 " + both(Bytes(128, 0x55)) + "10 03 EC"), 1U);
  EXPECT_EQ(count("B FF 00 00 00 " + both(Bytes(44, 0x55)) + "10 03 EC"), 1U);
  EXPECT_EQ(a.end(), "0000");
  EXPECT_EQ(a.target, Bytes(300, 0x55));
  EXPECT_TRUE(b.memory.flag({10, 3}));
}

// PTP-RK512-18, SFB64-05
TEST(LinkActive, FetchOfAnOddNumberOfBytes) {
  EXPECT_EQ(fetches(fetchJob('D', 10, 4, 3), "00 00 45 44 0A 02 00 02 FF 1F 10 03 F8",
                    "00 00 00 00 AA BB CC DD 10 03 13"),
            "AA BB CC");
}

// PTP-VEC-39, PTP-VEC-40, PTP-VEC-41, PTP-VEC-42, PTP-VEC-43, PTP-VEC-44, PTP-VEC-45, PTP-VEC-46,
// PTP-VEC-47 PTP-VEC-48, PTP-VEC-49, PTP-RK512-14, PTP-RK512-35, PTP-RK512-47, PTP-RK512-48,
// PTP-RK512-49, PTP-RK512-50 PTP-RK512-51, PTP-RK512-52, PTP-RK512-53, PTP-RK512-54, PTP-RK512-55,
// PTP-RK512-56, PTP-RK512-57 PTP-ERR-50, PTP-ERR-51, PTP-ERR-52, PTP-ERR-53, PTP-ERR-54,
// PTP-ERR-55, PTP-ERR-56, PTP-ERR-57, PTP-ERR-58 PTP-ERR-59, PTP-OPEN-15
TEST(LinkActive, EachErrorNumberOfAReaction) {
  const std::pair<const char*, const char*> rows[] = {
      {"0A 10 03 19", "0905"}, {"0C 10 03 1F", "0902"}, {"10 10 10 03 13", "090B"},
      {"12 10 03 01", "0904"}, {"14 10 03 07", "0903"}, {"16 10 03 05", "090A"},
      {"2A 10 03 39", "090D"}, {"32 10 03 21", "0909"}, {"34 10 03 27", "090C"},
      {"36 10 03 25", "0908"}, {"77 10 03 64", "090E"}};
  for (const auto& [reaction, event] : rows) {
    LinkedScript send, fetch;
    send.answers("00 00 41 44 0A 00 00 01 FF 1F 11 22 10 03 CE",
                 std::string("00 00 00 ") + reaction);
    send.begin(sendJob(10, 0, 2), hex("11 22"));
    send.run(200);
    EXPECT_EQ(send.cpu.end(), event);
    fetch.answers("00 00 45 44 0A 00 00 01 FF 1F 10 03 F9", std::string("00 00 00 ") + reaction);
    fetch.begin(fetchJob('D', 10, 0, 2));
    fetch.run(200);
    EXPECT_EQ(fetch.cpu.end(), event);
    EXPECT_TRUE(send.partner.done() && fetch.partner.done());
  }
}

// PTP-VEC-50, PTP-VEC-51, PTP-RK512-36, PTP-ERR-60, PTP-ERR-61
TEST(LinkActive, WrongReactions) {
  const std::tuple<bool, const char*, const char*> rows[] = {
      {false, "01 00 00 00 10 03 12", "0A02"},
      {false, "FF 00 00 00 10 03 EC", "0A01"},
      {false, "00 00 00 00 AA 10 03 B9", "0A03"},
      {false, "00 00 00 10 03 13", "0A03"},
      {true, "00 00 00 00 AA BB 10 03 02", "0A03"},
      {true, "00 00 00 00 AA BB CC DD EE FF 10 03 02", "0A03"}};
  for (const auto& [isFetch, reaction, event] : rows) {
    LinkedScript s;
    if (isFetch) {
      s.answers("00 00 45 44 0A 02 00 02 FF 1F 10 03 F8", reaction);
      s.begin(fetchJob('D', 10, 4, 4));
    } else {
      s.answers("00 00 41 44 0A 00 00 01 FF 1F 11 22 10 03 CE", reaction);
      s.begin(sendJob(10, 0, 2), hex("11 22"));
    }
    s.run(200);
    EXPECT_EQ(s.cpu.end(), event) << reaction;
  }
}

// PTP-VEC-52, PTP-RK512-26, PTP-RK512-37, PTP-ERR-62, PTP-OPEN-02
TEST(LinkActive, NoReaction) {
  LinkedScript s;
  s.partner.expect("02")
      .send("10")
      .expect("00 00 41 44 0A 00 00 01 FF 1F 11 22 10 03 CE")
      .send("10");
  s.begin(sendJob(10, 0, 2), hex("11 22"));
  s.run(100);
  const Instant acknowledged = s.lines.seen.back().end;
  while (s.lines.now + Duration::milliseconds(1) < acknowledged + Duration::seconds(20)) s.run(1);
  EXPECT_EQ(s.cpu.end(), "none");
  s.run(1);
  EXPECT_EQ(s.cpu.end(), "0A05");
}

// PTP-VEC-60, PTP-RK512-27, PTP-RK512-28, PTP-RK512-38
TEST(LinkActive, CommandOfThePartnerBeforeItsReaction) {
  LinkedScript s;
  Bytes first = counting(128);
  first.insert(first.begin() + 17, 0x10);
  Bytes second = counting(200);
  second.erase(second.begin(), second.begin() + 128);
  std::uint8_t check = 0xFF ^ 0x41 ^ 0x44 ^ 0x13;
  for (const std::uint8_t byte : second) check ^= byte;
  std::uint8_t checkFirst = 0x41 ^ 0x44 ^ 0x0A ^ 0x64 ^ 0xFF ^ 0x1F ^ 0x13;
  for (const std::uint8_t byte : first) checkFirst ^= byte;
  s.cpu.memory.db(11).resize(10);
  s.answers("00 00 41 44 0A 00 00 64 FF 1F " + both(first) + "10 03 " + text({checkFirst}),
            "00 00 00 00 10 03 13");
  s.partner.expect("02").send("10").expect("FF 00 41 44 " + both(second) + "10 03 " +
                                           text({check}));
  s.partner.send("10 02").expect("10").send("00 00 41 44 0B 00 00 01 FF 1F AA BB 10 03 ED");
  s.partner.expect("10").send("02").expect("10").send("FF 00 00 00 10 03 EC").expect("10");
  s.partner.expect("02").send("10").expect("00 00 00 00 10 03 13").send("10");
  s.begin(sendJob(10, 0, 200), counting(200));
  s.cpu.serves = false;  // it is called between the two telegrams of the partner
  for (unsigned i = 0; i < 2'000; ++i) {
    if (s.cpu.driver.outbox().takeEnd()) s.cpu.serves = true;
    s.run(1);
    if (i == 10) s.cpu.driver.serve(s.cpu.memory, s.lines.now);
  }
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(text(s.cpu.memory.db(11)).substr(0, 5), "AA BB");
  EXPECT_EQ(s.cpu.events(), "0000");
}

// PTP-RK512-27, PTP-RK512-30
TEST(LinkActive, CrossingJobs) {
  LinkCpu a, b(false);
  Coupled lines(a.driver, b.driver);
  for (LinkCpu* cpu : {&a, &b}) cpu->memory.db(20).resize(300);
  a.begin(sendJob(20, 0, 300), Bytes(300, 0xAA), lines.now);
  b.begin(sendJob(20, 0, 300), Bytes(300, 0xBB), lines.now);
  cycles(lines, {&a, &b}, 5'000);
  EXPECT_EQ(a.end(), "0000");
  EXPECT_EQ(b.end(), "0000");
  EXPECT_EQ(b.memory.db(20), Bytes(300, 0xAA));
  EXPECT_EQ(a.memory.db(20), Bytes(300, 0xBB));
  EXPECT_EQ(a.events(), "0000");
}

// PTP-RK512-29
TEST(LinkActive, ReactionWithoutAJobIsDiscarded) {
  LinkedScript s;
  s.partner.send("02").expect("10").send("00 00 00 00 10 03 13").expect("10");
  s.run(500);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.cpu.events(), "");
  EXPECT_EQ(s.lines.trace(), "B 02 | A 10 | B 00 00 00 00 10 03 13 | A 10");
}

// PTP-RK512-32, PTP-RK512-33
TEST(LinkActive, ErrorsOfTheProcedureEndTheJob) {
  LinkedScript s;
  s.begin(sendJob(10, 0, 2), hex("11 22"));
  s.run(12'100);
  EXPECT_EQ(s.cpu.end(), "0703");
}

// PTP-RK512-39, PTP-ERR-03, PTP-ERR-10
TEST(LinkActive, AbortedJobAndItsLateReaction) {
  LinkedScript s;
  const char* command = "00 00 41 44 0A 00 00 01 FF 1F 11 22 10 03 CE";
  s.partner.expect("02").send("10").expect(command).send("10").wait(200);
  s.partner.send("02").expect("10").send("00 00 00 36 10 03 25").expect("10");
  s.answers(command, "00 00 00 00 10 03 13");
  s.begin(sendJob(10, 0, 2), hex("11 22"));
  s.run(100);
  s.cpu.driver.abort(Event::Reset);
  EXPECT_EQ(s.cpu.end(), "051D");
  s.run(300);
  s.begin(sendJob(10, 0, 2), hex("11 22"));
  s.run(300);
  EXPECT_EQ(s.cpu.end(), "0000");
  EXPECT_TRUE(s.partner.done());
  s.begin(sendJob(10, 0, 2), hex("11 22"));
  s.run(20);
  s.cpu.driver.cpuStopped();
  EXPECT_EQ(s.cpu.end(), "0501");
}

// A FETCH of two bytes is aborted while its partner thinks, then another one is started.
struct AbortedFetch {
  AbortedFetch() {
    s.partner.expect("02").send("10").expect("00 00 45 44 0A 00 00 01 FF 1F 10 03 F9");
    s.partner.send("10").wait(100);
    s.begin(fetchJob('D', 10, 0, 2));
    s.run(60);
    s.cpu.driver.abort(Event::Reset);
    EXPECT_EQ(s.cpu.end(), "051D");
  }
  void fetchNext() {
    s.partner.expect("02").send("10").expect("00 00 45 44 0B 00 00 01 FF 1F 10 03 F8").send("10");
    s.begin(fetchJob('D', 11, 0, 2));
  }
  LinkedScript s;
};

// PTP-RK512-39: while the next job waits for its own
TEST(LinkActive, LateReactionOfAnAbortedJob) {
  for (const char* late : {"00 00 00 00 11 22 10 03 20", "00 00 00 0A 10 03 19"}) {
    AbortedFetch f;
    f.fetchNext();
    f.s.partner.wait(20).send("02").expect("10").send(late).expect("10").wait(20);
    f.s.partner.send("02").expect("10").send("00 00 00 00 33 44 10 03 64").expect("10");
    f.s.run(1'000);
    EXPECT_TRUE(f.s.partner.done());
    EXPECT_EQ(f.s.cpu.end(), "0000");
    EXPECT_EQ(text(f.s.cpu.target), "33 44");
  }
}

// PTP-RK512-39: a partner that has forgotten the aborted job
TEST(LinkActive, OnlyReactionBehindAnAbortedJob) {
  AbortedFetch f;
  f.fetchNext();
  f.s.partner.send("02").expect("10").send("00 00 00 00 33 44 10 03 64").expect("10");
  f.s.run(19'000);
  EXPECT_TRUE(f.s.partner.done());
  EXPECT_EQ(f.s.cpu.end(), "none");
  f.s.run(2'000);
  EXPECT_EQ(f.s.cpu.end(), "0000");
  EXPECT_EQ(text(f.s.cpu.target), "33 44");
}

// PTP-RK512-39: what cannot be meant for the aborted job, or comes too late for it
TEST(LinkActive, ReactionThatIsNoneOfTheAbortedJob) {
  AbortedFetch f;
  f.s.partner.expect("02").send("10").expect("00 00 41 44 0A 00 00 01 FF 1F 11 22 10 03 CE");
  f.s.partner.send("10").send("02").expect("10").send("00 00 00 00 10 03 13").expect("10");
  f.s.begin(sendJob(10, 0, 2), hex("11 22"));
  f.s.run(500);
  EXPECT_EQ(f.s.cpu.end(), "0000");
  AbortedFetch late;
  late.s.run(20'000);
  late.fetchNext();
  late.s.partner.send("02").expect("10").send("00 00 00 00 33 44 10 03 64").expect("10");
  late.s.run(500);
  EXPECT_EQ(late.s.cpu.end(), "0000");
}

// SFB63-11, PTP-RK512-59
TEST(LinkActive, DataAreReadTelegramByTelegram) {
  LinkCpu a, b(false);
  Coupled lines(a.driver, b.driver);
  b.memory.db(20).resize(300);
  a.begin(sendJob(20, 0, 300), Bytes(300, 0xAA), lines.now);
  cycles(lines, {&a, &b}, 50);
  a.source[200] = 0xCC;
  cycles(lines, {&a, &b}, 1'000);
  EXPECT_EQ(a.end(), "0000");
  EXPECT_EQ(b.memory.db(20)[200], 0xCC);
}

}  // namespace
}  // namespace merker::serial
