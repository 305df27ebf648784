// Random conversations: whatever happens on the line, both partners agree about what arrived, and
// everything ends.
#include <random>

#include "ascii_stations.h"
#include "links.h"

namespace merker::serial {
namespace {

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  unsigned below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }
  bool once(unsigned in) { return below(in) == 0; }
  Bytes bytes(unsigned most) {
    static constexpr std::uint8_t kSpecial[] = {0x02, 0x03, 0x10, 0x15};
    Bytes result(1 + below(most));
    for (std::uint8_t& byte : result)
      byte = once(3) ? kSpecial[below(4)] : static_cast<std::uint8_t>(below(256));
    return result;
  }

 private:
  std::mt19937 random_;
};

// Damage that a block check finds for certain: nothing, a lost character, a parity or frame fault.
void disturb(Line& line, Chance& chance, unsigned rate) {
  static constexpr Fault::Kind kKinds[] = {Fault::Kind::Drop, Fault::Kind::Parity,
                                           Fault::Kind::Stop, Fault::Kind::Overrun};
  for (std::size_t i = 0; i < 2; ++i)
    if (chance.once(rate))
      line.port(i).disturb(line.port(i).characters() + chance.below(20), {kKinds[chance.below(4)]});
}

// PTP-P3964-51, PTP-P3964-56, PTP-LINE-09
TEST(Conversation, ProceduresAgree) {
  std::size_t delivered = 0, failed = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Chance chance(seed);
    Procedures p;
    struct Side {
      Procedure& driver;
      Mailbox& mail;
      std::vector<std::pair<Bytes, Event>> jobs;
      std::vector<Bytes> got;
    };
    Side sides[] = {{p.a, p.mailA, {}, {}}, {p.b, p.mailB, {}, {}}};
    for (unsigned step = 0; step < 600; ++step) {
      p.lines.run(1 + chance.below(60));
      disturb(p.lines.line, chance, 1 + seed % 20);
      for (Side& side : sides) {
        if (const auto end = side.driver.outbox().takeEnd()) side.jobs.back().second = *end;
        while (const auto entry = side.mail.take())
          if (entry->event == Event::None) side.got.push_back(entry->telegram);
        if (side.driver.outbox().busy() || !chance.once(10) || step > 500) continue;
        Bytes data = chance.bytes(40);
        data.push_back(static_cast<std::uint8_t>(side.jobs.size()));  // all different
        data.push_back(static_cast<std::uint8_t>(side.jobs.size() >> 8U));
        side.jobs.emplace_back(data, Event::Restarted);
        side.driver.send(data, p.lines.now);
      }
    }
    p.lines.run(60'000);
    for (std::size_t i = 0; i < 2; ++i) {
      Side& from = sides[i];
      Side& to = sides[1 - i];
      if (const auto end = from.driver.outbox().takeEnd()) from.jobs.back().second = *end;
      EXPECT_FALSE(from.driver.outbox().busy());
      while (const auto entry = to.mail.take())
        if (entry->event == Event::None) to.got.push_back(entry->telegram);
      std::size_t job = 0;
      std::vector<bool> arrived(from.jobs.size());
      for (const Bytes& telegram : to.got) {
        while (job < from.jobs.size() && from.jobs[job].first != telegram) ++job;
        ASSERT_LT(job, from.jobs.size()) << "seed " << seed << ": never sent, or out of order";
        arrived[job] = true;
      }
      for (job = 0; job < from.jobs.size(); ++job) {
        const bool good = from.jobs[job].second == Event::None;
        EXPECT_TRUE(arrived[job] || !good) << "seed " << seed << ": lost";
        (good ? delivered : failed) += 1;
      }
    }
    EXPECT_EQ(p.lines.line.next(), Instant::never());
  }
  EXPECT_GT(delivered, 1'000U);
  EXPECT_GT(failed, 5U);
}

// PTP-RK512-27, PTP-RK512-58
TEST(Conversation, ComputerLinksAgree) {
  std::size_t delivered = 0, failed = 0;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    Chance chance(seed);
    LinkCpu cpus[] = {LinkCpu(true), LinkCpu(false)};
    Coupled lines(cpus[0].driver, cpus[1].driver, {.baud = 38400}, {.baud = 38400});
    struct Running {
      LinkJob job;
      Bytes data;
    };
    std::optional<Running> running[2];
    for (LinkCpu& cpu : cpus) cpu.memory.db(20).resize(512);
    for (unsigned step = 0; step < 6'000; ++step) {
      lines.run(step > 5'000 ? 100 : 2);
      if (step < 4'000) disturb(lines.line, chance, 20 + 10 * (seed % 20));
      for (std::size_t i = 0; i < 2; ++i) {
        LinkCpu& cpu = cpus[i];
        LinkCpu& other = cpus[1 - i];
        cpu.call(lines.now);
        if (const auto end = cpu.driver.outbox().takeEnd()) {
          const auto& [job, data] = *running[i];
          const Bytes& area = other.memory.db(20);
          const auto begin = area.begin() + job.offset;
          const bool good = *end == Event::None;
          if (good && job.fetch) {
            EXPECT_EQ(cpu.target.size(), job.length);
          } else if (good) {
            EXPECT_EQ(Bytes(begin, begin + job.length), data) << "seed " << seed;
          }
          (good ? delivered : failed) += 1;
          running[i].reset();
        }
        if (running[i] || step > 5'000 || !chance.once(20)) continue;
        const Bytes data = chance.bytes(300);
        LinkJob job = sendJob(20, static_cast<std::uint16_t>(chance.below(100) * 2),
                              static_cast<std::uint16_t>(data.size()));
        job.fetch = chance.once(3);
        running[i] = Running{job, data};
        cpu.begin(job, data, lines.now);
      }
    }
    for (std::size_t i = 0; i < 2; ++i) EXPECT_FALSE(running[i]) << "seed " << seed;
  }
  EXPECT_GT(delivered, 300U);
  EXPECT_GT(failed, 0U);
}

// A partner that sends anything for ten minutes: nothing grows, time goes on, and then it works.
TEST(Conversation, HostilePartner) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Chance chance(seed);
    LinkedScript s;
    Scripted plain;
    AsciiCpu ascii(withFlow(byEnd()));
    for (unsigned step = 0; step < 3'000; ++step) {
      for (Script* partner : {&s.partner, &plain.partner, &ascii.partner}) {
        partner->heard.clear();
        if (chance.once(2)) partner->send(chance.bytes(30));
      }
      for (Coupled* lines : {&s.lines, &plain.lines, &ascii.lines}) {
        lines->run(1 + chance.below(chance.once(10) ? 500 : 50));
        lines->seen.clear();
      }
      s.cpu.call(s.lines.now);
      s.cpu.outcomes.clear();
      EXPECT_LE(plain.mail.bytes(), Mailbox::kSize);
    }
    ascii.lines.run(2'000);
    plain.lines.run(2'000);
    s.run(3'000);
    s.cpu.outcomes.clear();
    s.lines.seen.clear();
    s.partner = Script{};
    s.commands("00 00 45 4D 00 64 00 01 FF 1F 10 03 9E", "00 00 00 00 00 10 03 13");
    s.run(500);
    EXPECT_TRUE(s.partner.done()) << "seed " << seed;
  }
}

// PTP-ASCII-20
TEST(Conversation, AsciiArrivesWhateverTheDelays) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Chance chance(seed);
    AsciiCpu c;
    Mailbox mail;
    Ascii other({}, mail);
    Coupled lines(c.cpu, other);
    for (unsigned i = 0; i < 30; ++i) {
      const Bytes data = chance.bytes(200);
      c.cpu.send(data, lines.now);
      lines.run(260 + chance.below(20));
      EXPECT_EQ(c.end(), "0000");
      EXPECT_EQ(mail.take()->telegram, data);
    }
  }
}

}  // namespace
}  // namespace merker::serial
