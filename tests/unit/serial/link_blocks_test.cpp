// SEND_RK, FETCH_RK and SERVE_RK call by call, with a partner (rows SFB63 to SFB65 of the
// requirements, which need a program of a CPU to be shown as a whole).
#include "programs.h"

namespace merker::serial {
namespace {

class TwoLinks {
 public:
  TwoLinks()
      : a(of(Protocol::ComputerLink)),
        b(of(Protocol::ComputerLink, false)),
        lines(a.interface, b.interface) {
    b.memory.db(20).resize(400);
  }
  // A has a job; B calls SERVE_RK each millisecond.
  std::pair<std::string, unsigned> run(LinkJobBlock& block) {
    return a.until(lines, [&](bool first) {
      b.now = lines.now;
      const std::string shown = b.serve(true);
      if (shown != "-") served += shown + " ";
      if (b.served) job = b.served;
      return a.job(block, first);
    });
  }
  void settle() {
    for (unsigned i = 0; i < 20; ++i) {
      lines.run(1);
      b.now = lines.now;
      const std::string shown = b.serve(true);
      if (shown != "-") served += shown + " ";
      if (b.served) job = b.served;
    }
  }
  Program a, b;
  Coupled lines;
  std::string served;
  std::optional<LinkJob> job;
};

LinkRequest request(std::int32_t block, std::int32_t offset, std::int32_t length) {
  return {.block = block, .offset = offset, .length = length};
}

// SFB63-08, SFB65-05, SFB65-10
TEST(LinkBlocks, SendIsServed) {
  TwoLinks t;
  t.a.link = request(20, 10, 300);
  t.a.blocks.bytes[10] = counting(300);
  EXPECT_EQ(t.run(t.a.sendRk).first, "DONE 0000");
  t.settle();
  EXPECT_EQ(t.served, "DONE 0000 ");
  ASSERT_TRUE(t.job);
  EXPECT_EQ(t.job->type, 'D');
  EXPECT_EQ(t.job->block, 20);
  EXPECT_EQ(t.job->offset, 10);
  EXPECT_EQ(t.job->flag.byte, 255);
  EXPECT_EQ(t.job->length, 300);
  const Bytes& db = t.b.memory.db(20);
  EXPECT_EQ(Bytes(db.begin() + 10, db.begin() + 310), counting(300));
}

// SFB64-05, SFB64-06, SFB65-04
TEST(LinkBlocks, FetchIsServed) {
  TwoLinks t;
  t.b.memory.db(20) = counting(400);
  t.a.link = request(20, 0, 299);
  t.a.blocks.bytes[10] = Bytes(300, 0xEE);
  EXPECT_EQ(t.run(t.a.fetchRk).first, "DONE 0000");
  EXPECT_EQ(t.a.blocks.read({10, 0}, 299), Bytes(counting(299)));
  EXPECT_EQ(t.a.blocks.bytes[10][299], 0xEE);
}

// SFB63-03 to -07, SFB63-09, SFB64-02 to -04, ERR-06 to -09
TEST(LinkBlocks, WrongParameters) {
  const std::tuple<LinkRequest, const char*, const char*> rows[] = {
      {{.cpu = 5}, "ERROR 0516", "ERROR 0516"},
      {{.cpu = -1}, "ERROR 0516", "ERROR 0516"},
      {{.cpu = 4}, "-", "-"},
      {{.type = 'd'}, "ERROR 0513", "ERROR 0513"},
      {{.type = 'M'}, "ERROR 0513", "-"},
      {{.type = 'Q'}, "ERROR 0513", "ERROR 0513"},
      {{.type = 'X'}, "-", "-"},
      {{.block = 256}, "ERROR 0301", "ERROR 0301"},
      {{.offset = 511}, "ERROR 0301", "ERROR 0301"},
      {{.offset = 510}, "-", "-"},
      {{.type = 'M', .offset = 256}, "ERROR 0513", "ERROR 0301"},
      {{.type = 'M', .block = 999, .offset = 255}, "ERROR 0513", "-"},
      {{.flagByte = 100, .flagBit = 8}, "ERROR 0515", "ERROR 0515"},
      {{.flagByte = 255, .flagBit = 8}, "-", "-"},
      {{.flagByte = 256}, "ERROR 0301", "ERROR 0301"},
      {{.length = 1'025}, "ERROR 0517", "ERROR 0517"},
      {{.length = 1'024}, "-", "-"},
      {{.length = 0}, "ERROR 050E", "ERROR 050E"}};
  for (const auto& [link, send, fetch] : rows) {
    Program p(of(Protocol::ComputerLink));
    p.link = link;
    EXPECT_EQ(p.job(p.sendRk, true), "-");
    EXPECT_EQ(p.job(p.sendRk, true), send);
    p.interface.abort(Event::Reset);
    p.interface.outbox().takeEnd();
    EXPECT_EQ(p.job(p.fetchRk, true), "-");
    EXPECT_EQ(p.job(p.fetchRk, true), fetch);
  }
}

// RK512-31, ERR-11
TEST(LinkBlocks, SendAndFetchAreNotActiveTogether) {
  TwoLinks t;
  t.a.link = request(20, 0, 2);
  t.a.job(t.a.sendRk, true);
  EXPECT_EQ(joined({t.a.job(t.a.fetchRk, true), t.a.job(t.a.fetchRk, true)}), "-ERROR 0522");
  EXPECT_EQ(t.run(t.a.sendRk).first, "DONE 0000");
}

// SFBG-16: R at SEND_RK
TEST(LinkBlocks, ResetOfAJob) {
  TwoLinks t;
  t.a.link = request(20, 0, 300);
  t.a.job(t.a.sendRk, true);
  t.lines.run(50);
  EXPECT_EQ(t.a.job(t.a.sendRk, true, true), "-");
  EXPECT_EQ(t.a.job(t.a.sendRk, true, true), "-");
  EXPECT_EQ(t.a.job(t.a.sendRk, true, true), "ERROR 051D");
}

// SFB65-01, SFB65-06
TEST(LinkBlocks, ResetOfServing) {
  TwoLinks t;
  EXPECT_EQ(joined({t.b.serve(true, true), t.b.serve(true), t.b.serve(true)}), "--DONE 0000");
  EXPECT_FALSE(t.b.served);
  t.a.link = request(20, 0, 300);
  t.a.job(t.a.sendRk, true);
  for (unsigned i = 0; i < 230; ++i) {  // until it waits for a follow-on telegram
    t.lines.run(1);
    t.a.now = t.b.now = t.lines.now;
    t.b.serve(true);
  }
  ASSERT_TRUE(t.b.interface.link()->serving());
  EXPECT_EQ(joined({t.b.serve(true, true), t.b.serve(true), t.b.serve(true)}), "--ERROR 051D");
}

// SFB63-11, ERR-02: an area that becomes too short during the job.
TEST(LinkBlocks, AreaThatDisappears) {
  TwoLinks t;
  t.a.link = request(20, 0, 300);
  t.a.job(t.a.sendRk, true);
  t.a.blocks.bytes[10].resize(200);
  EXPECT_EQ(t.run(t.a.sendRk).first, "ERROR 0303");
}

// SFBG-19
TEST(LinkBlocks, StopOfTheCpu) {
  TwoLinks t;
  t.a.link = request(20, 0, 300);
  t.a.job(t.a.sendRk, true);
  t.lines.run(50);
  t.a.interface.cpuStopped();
  t.lines.run(50);
  t.a.interface.cpuStarted();
  t.a.sendRk.start();
  EXPECT_EQ(t.a.until(t.lines, [&](bool) { return t.a.job(t.a.sendRk, false); }).first,
            "ERROR 0501");
}

}  // namespace
}  // namespace merker::serial
