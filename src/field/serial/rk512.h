// The computer link RK 512 on top of the procedure 3964(R) (technology manual 6.9.3; PTP-RK512).
// Its active half sends SEND and FETCH for the CPU, its passive half answers those of the partner.
#pragma once

#include <deque>

#include "serial/procedure.h"
#include "serial/telegram.h"

namespace merker::serial {

// The CPU as a job of the partner sees it. Timers and counters are words.
class LinkMemory {
 public:
  virtual ~LinkMemory() = default;
  // Bytes of a data block or area, nothing if it does not exist.
  virtual std::optional<std::size_t> size(char type, std::uint8_t block) const = 0;
  virtual bool writable(std::uint8_t block) const = 0;  // a data block that exists
  virtual Bytes read(char type, std::uint8_t block, std::size_t offset,
                     std::size_t count) const = 0;
  virtual void write(std::uint8_t block, std::size_t offset,
                     std::span<const std::uint8_t> data) = 0;
  virtual bool flag(const Flag& flag) const = 0;
  virtual void setFlag(const Flag& flag) = 0;
};

struct LinkParameters {
  ProcedureParameters procedure;
  Duration reactionTime = Duration::seconds(20);  // the charts print 10 s (PTP-OPEN-02)
  Preparation preparation = kRk512Preparation;
};

class Rk512 : public Driver, private Inbox {
 public:
  explicit Rk512(const LinkParameters& parameters);
  Rk512(const Rk512&) = delete;
  Rk512& operator=(const Rk512&) = delete;

  // The active half. A job asks for its data part by part, and hands out what was fetched.
  void begin(const LinkJob& job, Instant now);  // only while there is no job
  void abort(Event why);
  Outbox& outbox() { return outbox_; }
  struct Part {
    std::size_t offset = 0, count = 0;
  };
  std::optional<Part> wanted() const;  // bytes of a SEND for its next telegram
  void supply(Bytes data, Instant now);
  std::optional<Bytes> takeFetched(Instant now);

  // The passive half: one call of SERVE_RK.
  void serve(LinkMemory& memory, Instant now);
  void disable(Event why);  // EN_R is FALSE, or R
  bool serving() const { return passive_ != Passive::Idle; }
  struct Outcome {
    Event event = Event::None;  // None: the job is done
    LinkJob job;
  };
  std::optional<Outcome> takeOutcome();

  void cpuStopped();
  void cpuStarted();

  void start(Instant now) override { procedure_.start(now); }
  void received(const Character& character) override;
  void interrupted(Instant at) override;
  void restored(Instant at) override { procedure_.restored(at); }
  std::optional<std::uint8_t> next(Instant now) override { return procedure_.next(now); }
  void sent(Instant at) override { procedure_.sent(at); }
  Instant due() const override;
  void expire(Instant now) override;

 private:
  enum class Active : std::uint8_t { Idle, NeedsData, Prepares, Sends, Waits, HasData };
  enum class Passive : std::uint8_t { Idle, Pending, Reacts, Follows };
  enum class Service : std::uint8_t { Never, Disabled, Enabled };
  enum class Output : std::uint8_t { Nothing, CommandTelegram, ReactionTelegram };

  bool free() const override { return true; }  // there is no receive buffer (PTP-PARAM-34)
  Event put(Bytes telegram) override;
  void report(Event event) override;
  void pump(Instant now);  // what the procedure has done, and what it sends next
  void react(Bytes telegram, bool ofJob);

  // rk512_active.cpp
  void prepare(Instant now, std::size_t bytes);
  void endJob(Event event);
  void commandSent(Event event, Instant now);
  void takeReaction(const Bytes& telegram);
  bool ofAbortedJob(const Bytes& telegram);
  void useReaction(const Bytes& telegram);
  void reactionOverdue();
  std::size_t part() const;

  // rk512_passive.cpp
  void takeCommand(const Bytes& telegram);
  bool continues(const Bytes& telegram);
  void refuse(bool followOn, Event event, std::uint8_t error);
  void outcome(Event event);
  std::size_t partnerPart() const;
  Denial check(const LinkMemory& memory) const;
  void execute(LinkMemory& memory);
  void reactionSent(Event event, Instant now);
  void passiveExpired();

  LinkParameters parameters_;
  Procedure procedure_;
  Instant now_;
  Output output_ = Output::Nothing;  // in the procedure

  Active active_ = Active::Idle;
  LinkJob job_;
  Outbox outbox_;
  Bytes command_, fetched_;
  bool commandReady_ = false;
  std::size_t done_ = 0;  // bytes of the active job
  Instant activeTimer_ = Instant::never();
  struct Owed {  // the reaction to a command whose job was aborted
    Instant until;
    bool followOn = false;
    std::size_t data = 0;
  };
  std::deque<Owed> owed_;
  std::optional<Bytes> doubtful_;  // a reaction: of this job, or of one that was aborted

  Passive passive_ = Passive::Idle;
  Service service_ = Service::Never;
  bool stopped_ = false;
  LinkJob partnerJob_;
  Denial header_;  // what is wrong with its header behind the address
  bool followOn_ = false;
  Bytes data_;  // that came with the command
  std::size_t served_ = 0;
  Instant passiveTimer_ = Instant::never();
  struct Reply {
    Bytes telegram;
    bool ofJob = false;  // the job of the partner has come further when it is acknowledged
  };
  std::deque<Reply> replies_;
  bool replyOfJob_ = false;  // the one that is being sent
  std::optional<LinkJob> completed_;
  std::deque<Outcome> outcomes_;
};

}  // namespace merker::serial
