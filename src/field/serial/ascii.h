// The ASCII driver (technology manual 6.9.1; PTP-ASCII). Sending and receiving are two machines;
// over two wires (RS 485) the sender waits for the receiver.
#pragma once

#include "serial/driver.h"
#include "serial/mailbox.h"
#include "serial/outbox.h"

namespace merker::serial {

struct AsciiParameters {
  enum class End : std::uint8_t { Delay, Count, Characters };
  enum class Sending : std::uint8_t { UpToEnd, Length, Append };  // with end characters

  End end = End::Delay;
  Duration delay = Duration::milliseconds(4);  // ZVZ, or the monitoring time of the other criteria
  std::uint16_t length = 1024;                 // Count
  bool pause = true;                           // Count: before each telegram
  std::uint8_t endCharacters = 1, checkCharacters = 0;
  std::uint8_t end1 = 0x03, end2 = 0;
  Sending sending = Sending::UpToEnd;

  bool flowControl = false;
  std::uint8_t xon = 0x11, xoff = 0x13;
  Duration xonWait = Duration::seconds(20);

  bool twoWire = false;
  bool discardInStop = false;  // reaction to CPU STOP: STOP
  std::uint8_t mask = 0xFF;    // of the data bits
  Preparation preparation = kAsciiPreparation;
};

class Ascii : public Driver {
 public:
  // The mailbox must outlive it.
  Ascii(const AsciiParameters& parameters, Mailbox& mailbox)
      : parameters_(parameters), mailbox_(mailbox) {}

  void send(const Bytes& data, Instant now);  // only while there is no job
  void abort(Event why);                      // ends the job; nothing without one
  Outbox& outbox() { return outbox_; }
  void fetched();  // something was taken out of the mailbox
  void cpuStopped();
  void cpuStarted();

  void start(Instant now) override;
  void received(const Character& character) override;
  void interrupted(Instant at) override;
  void restored(Instant) override {}
  std::optional<std::uint8_t> next(Instant now) override;
  void sent(Instant at) override;
  Instant due() const override;
  void expire(Instant now) override;

 private:
  enum class Sender : std::uint8_t { Idle, Waiting, Sending, Held };
  enum class Reader : std::uint8_t { Idle, Receive, Check, Skip };  // Skip: to its end, too long

  // ascii_send.cpp
  std::optional<Bytes> telegramOf(const Bytes& data) const;
  Instant mayBegin() const;
  void begin(Instant now);
  void end(Event event);
  void hold(Instant now);
  bool flow(const Character& c);
  bool wantsXoff() const;
  void adjustFlow();

  // ascii_receive.cpp
  void store(const Character& c);
  bool complete() const;
  bool endMark() const;
  void look();
  void note(Event event);
  void quiet();
  void deliver();
  void forget();

  AsciiParameters parameters_;
  Mailbox& mailbox_;
  Outbox outbox_;

  Sender sender_ = Sender::Idle;
  Bytes telegram_;
  std::size_t index_ = 0;
  Instant ready_, pauseUntil_{INT64_MIN}, xonUntil_ = Instant::never();
  bool xoffReceived_ = false, leaving_ = false;  // leaving: a character of the telegram
  std::vector<std::uint8_t> pending_;            // XON, XOFF
  bool xoffSent_ = false, stopped_ = false;

  Reader reader_ = Reader::Idle;
  Bytes data_;
  std::size_t marks_ = 0;  // good characters since the last faulty one
  unsigned checksLeft_ = 0;
  Event fault_ = Event::None;
  Instant quietAt_ = Instant::never();
};

}  // namespace merker::serial
