// What stands at the other end of a line: it sends what it is told, keeps what arrives, and answers
// by rules. Without a protocol it sees single characters; with one of its own, telegrams.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "serial/parameters.h"
#include "serial/partner_memory.h"
#include "serial/rk512.h"

namespace merker::serial {

class Partner : public Driver, private Inbox {
 public:
  static constexpr std::size_t kMost = 65'536;  // bytes kept, bytes that wait to be sent
  static constexpr std::size_t kMostRules = 100, kMostDelayed = 1'000;

  enum class Speaks : std::uint8_t { Characters, Procedure, ComputerLink };
  // From now on so; what was on its way, or has arrived, is lost.
  void speak(Speaks what, const ProcedureParameters& procedure, Instant now);
  Speaks speaks() const { return speaks_; }

  // Characters, or a telegram. False: too much waits to be sent already.
  bool send(const Bytes& data, Instant now);
  std::size_t queued() const { return characters_.size(); }
  std::size_t room() const { return kMost - std::min(waiting_, kMost); }
  // RK 512: a job of its own; what it fetches is received.
  bool begin(const LinkJob& job, Bytes data, Instant now);
  PartnerMemory& memory() { return memory_; }
  const PartnerMemory& memory() const { return memory_; }

  // Characters that end so, or a telegram that begins so, are answered.
  struct Rule {
    Bytes wanted, answer;
    Duration after;
  };
  bool answer(const Rule& rule);
  void forgetRules() { rules_.clear(); }

  // What has arrived and was not taken: the oldest first.
  struct Received {
    Bytes bytes;
    Instant at;
    std::uint8_t faults = 0;
  };
  const std::deque<Received>& received() const { return received_; }
  // True, and taken: what arrived begins with these characters, or is this telegram.
  bool take(const Bytes& wanted);
  Bytes takeAll();  // the characters
  void forget() { received_.clear(), kept_ = 0; }
  // How its last job or telegram ended.
  std::optional<Event> ended() const { return ended_; }

  void start(Instant now) override;
  void received(const Character& character) override;
  void interrupted(Instant at) override;
  void restored(Instant at) override;
  std::optional<std::uint8_t> next(Instant now) override;
  void sent(Instant at) override;
  Instant due() const override;
  void expire(Instant now) override;

 private:
  bool free() const override { return true; }
  Event put(Bytes telegram) override;
  void report(Event) override {}
  Driver* protocol() const;
  void keep(Bytes bytes, Instant at, std::uint8_t faults);
  void react(Instant at);
  void pump(Instant now);
  void pumpLink(Instant now);
  bool fits(const Rule& rule) const;

  Speaks speaks_ = Speaks::Characters;
  std::unique_ptr<Procedure> procedure_;
  std::unique_ptr<Rk512> link_;
  PartnerMemory memory_;
  Bytes jobData_;
  std::deque<std::uint8_t> characters_;    // to be sent
  std::deque<Bytes> telegrams_;            // to be sent
  std::size_t waiting_ = 0;                // bytes of both
  std::multimap<Instant, Bytes> delayed_;  // answers
  std::vector<Rule> rules_;
  std::deque<Received> received_;
  std::size_t kept_ = 0;
  std::deque<std::uint8_t> recent_;  // characters that rules look at
  std::optional<Bytes> arrived_;     // a telegram that rules look at
  std::optional<Event> ended_;
  Instant now_;
};

}  // namespace merker::serial
