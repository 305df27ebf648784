// A partner that sends anything: random characters, telegrams without end, replies that nobody
// asked for. The drivers keep to their limits and work again when it is over.
#include <gtest/gtest.h>
#include <malloc.h>

#include <random>

#include "serial/coupling.h"
#include "stations.h"

namespace merker::serial {
namespace {

constexpr Instant at(std::int64_t ms) { return Instant{} + Duration::milliseconds(ms); }

constexpr std::uint8_t kControl[] = {0x02, 0x03, 0x10, 0x15, 0x11, 0x13, 0x00, 0xFF, 'A', 'E', 'D'};

// Characters that look like the protocol more often than chance would have it.
Bytes noise(std::mt19937& random, std::size_t count) {
  Bytes bytes;
  for (std::size_t i = 0; i < count; ++i)
    bytes.push_back(random() % 2 == 0 ? kControl[random() % std::size(kControl)]
                                      : static_cast<std::uint8_t>(random()));
  return bytes;
}

// The heap that is in use.
std::size_t inUse() { return mallinfo2().uordblks; }

class Hostile : public testing::TestWithParam<Protocol> {
 protected:
  // Ten minutes, in pieces of a second; the CPU starts a job now and then and takes what has come.
  void storm(Coupling& coupling, std::mt19937& random) {
    for (int second = 0; second < 600; ++second, now_ = now_ + Duration::seconds(1)) {
      coupling.advance(now_);
      coupling.partner().forget();
      coupling.partner().send(noise(random, random() % 900), now_);
      if (random() % 50 == 0) coupling.cut(Coupling::End::Cpu, random() % 2 == 0, now_);
      if (random() % 10 == 0) coupling.noise(Coupling::End::Cpu, 0x2AA, now_);
      work(coupling, random);
    }
    coupling.cut(Coupling::End::Cpu, false, now_);
  }
  void work(Coupling& coupling, std::mt19937& random) {
    Interface& interface = coupling.interface();
    if (Rk512* link = interface.link()) {
      if (link->outbox().free() && random() % 4 == 0)
        link->begin({.fetch = random() % 2 == 0, .type = 'D', .block = 10, .length = 4}, now_);
      link->outbox().takeEnd();
      return;
    }
    if (interface.outbox().free() && random() % 4 == 0)
      interface.send(noise(random, 1 + random() % 50), now_);
    interface.outbox().takeEnd();
    if (random() % 3 == 0) interface.take();
  }
  Instant now_ = at(0);
};

TEST_P(Hostile, MemoryHasAnEndAndTheLineWorksAgain) {
  std::mt19937 random(26);
  Coupling coupling(defaults(GetParam()));
  storm(coupling, random);
  const std::size_t before = inUse();
  storm(coupling, random);
  EXPECT_LT(inUse(), before + 300'000);
  EXPECT_LE(coupling.sightings().size(), Coupling::kMostSightings);
  EXPECT_GT(coupling.seen(), 400'000U);

  if (coupling.interface().linked()) return;
  now_ = now_ + Duration::seconds(120);  // what waits, and each timer
  coupling.advance(now_);
  coupling.interface().clear();
  while (coupling.interface().take()) continue;
  ProcedureParameters other = coupling.parameters().procedure;
  other.highPriority = false;
  const bool characters = GetParam() == Protocol::Ascii;
  coupling.partner().speak(characters ? Partner::Speaks::Characters : Partner::Speaks::Procedure,
                           other, now_);
  now_ = now_ + Duration::seconds(10);
  coupling.advance(now_);
  coupling.interface().clear();
  ASSERT_TRUE(coupling.partner().send({'O', 'K'}, now_));
  coupling.advance(now_);
  coupling.advance(now_ + Duration::seconds(5));
  const auto entry = coupling.interface().take();
  ASSERT_TRUE(entry);
  EXPECT_EQ(text(entry->telegram), "4F 4B");
}

INSTANTIATE_TEST_SUITE_P(Protocols, Hostile,
                         testing::Values(Protocol::Ascii, Protocol::Procedure,
                                         Protocol::ComputerLink));

// PTP-P3964-30: a telegram without end is refused, and nothing of it stays.
TEST(Hostile, ATelegramWithoutEnd) {
  Coupling coupling(defaults(Protocol::Procedure));
  coupling.advance(at(10));
  coupling.partner().send({0x02}, at(10));
  for (int i = 0; i < 100; ++i) {
    coupling.partner().send(Bytes(500, 0x41), at(20 + 500 * i));
    coupling.advance(at(20 + 500 * (i + 1)));
  }
  EXPECT_LE(coupling.sightings().size(), Coupling::kMostSightings);
  coupling.advance(at(60'000));
  while (const auto entry = coupling.interface().take()) EXPECT_TRUE(entry->telegram.empty());
}

}  // namespace
}  // namespace merker::serial
