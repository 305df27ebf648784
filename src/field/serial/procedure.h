// The procedure 3964(R) (technology manual 6.9.2; PTP-P3964). One machine: it either sends or
// receives a block.
#pragma once

#include <array>

#include "serial/driver.h"
#include "serial/mailbox.h"
#include "serial/outbox.h"

namespace merker::serial {

struct ProcedureParameters {
  bool blockCheck = true;  // 3964R
  bool highPriority = true;
  Duration characterDelay = Duration::milliseconds(220);      // ZVZ
  Duration acknowledgeDelay = Duration::milliseconds(2'000);  // QVZ
  std::uint8_t setups = 6, transmissions = 6;
  std::uint8_t mask = 0xFF;  // of the data bits
  Preparation preparation = kProcedurePreparation;
};
constexpr Duration kDelayWithoutBlockCheck = Duration::milliseconds(550);  // QVZ (PTP-OPEN-01)

class Procedure : public Driver {
 public:
  static constexpr std::uint8_t kStx = 0x02, kEtx = 0x03, kDle = 0x10, kNak = 0x15;

  // The inbox must outlive it.
  Procedure(const ProcedureParameters& parameters, Inbox& inbox)
      : parameters_(parameters), inbox_(inbox) {}

  void send(const Bytes& data, Instant now);  // only while there is no job
  void abort(Event why);                      // ends the job; nothing without one
  Outbox& outbox() { return outbox_; }

  void start(Instant now) override;
  void received(const Character& character) override;
  void interrupted(Instant at) override;
  void restored(Instant at) override;
  std::optional<std::uint8_t> next(Instant now) override;
  void sent(Instant at) override;
  Instant due() const override;
  void expire(Instant now) override;

 private:
  enum class State : std::uint8_t {
    Idle,
    Connect,     // STX sent
    Sending,     // the block
    Disturbed,   // a character came while sending: until the line is quiet
    Close,       // block sent
    Stray,       // an unexpected character came in idle: until the line is quiet
    WaitBuffer,  // STX came, no free buffer
    Receive,
    GotDle,
    GetBcc,
    WaitRepeat  // after NAK
  };
  struct Reaction {  // of a state, to a character and to its timer
    void (Procedure::*received)(const Character&);
    void (Procedure::*expired)(Instant);
  };
  static const std::array<Reaction, 11> kReactions;
  struct Job {
    Bytes block;
    std::size_t closing = 0;  // where DLE ETX (BCC) begins
    Instant ready;
    unsigned setup = 1, transmission = 1, conflicts = 0;
    bool conflict = false;  // in this attempt
    Event first = Event::None;
  };
  struct Reception {
    Bytes data;
    std::uint8_t check = 0;
    bool afterConflict = false;
    unsigned transmission = 1;
    Event first = Event::None;  // of the whole reception
    bool bad = false;           // this attempt: NAK at its end
    bool shown = false;         // its error was reported
  };

  void enter(State state, Instant timer = Instant::never());
  bool sends() const;
  void control(std::uint8_t value) { pending_.push_back(value); }

  // procedure_send.cpp
  void connect();
  void retrySetup(Event event);
  void retryBlock(Event event, bool quiet);
  void endJob(Event event);
  void inConnect(const Character& c);
  void inSending(const Character& c);
  void inDisturbed(const Character& c);
  void inClose(const Character& c);
  void connectExpired(Instant now);
  void disturbedExpired(Instant now);
  void closeExpired(Instant now);

  // procedure_receive.cpp
  void idle(Instant now);
  void accept(Instant now);
  void open();
  void note(Event event);
  void finish(Instant now);
  void fail(Instant now);
  void inIdle(const Character& c);
  void inStray(const Character& c);
  void inWaitBuffer(const Character& c);
  void inReceive(const Character& c);
  void inGotDle(const Character& c);
  void inGetBcc(const Character& c);
  void inWaitRepeat(const Character& c);
  void ignoreTimer(Instant) {}
  void strayExpired(Instant now);
  void waitBufferExpired(Instant now);
  void receiveExpired(Instant now);
  void waitRepeatExpired(Instant now);
  void store(std::uint8_t value);

  ProcedureParameters parameters_;
  Inbox& inbox_;
  Outbox outbox_;
  State state_ = State::Idle;
  Instant timer_ = Instant::never(), bufferUntil_;
  std::vector<std::uint8_t> pending_;  // control characters to send
  std::uint8_t leaving_ = 0;           // what is on its way out
  std::size_t index_ = 0;
  std::optional<Job> job_;
  Reception reception_;
  bool broken_ = false;
};

}  // namespace merker::serial
