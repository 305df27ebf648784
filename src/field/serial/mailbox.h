// The receive buffer of the CPU: 2048 bytes, oldest telegram first, and beside the telegrams the
// errors that belong between them (technology manual 6.9.1.3, 6.9.2.7; PTP-ASCII-22 to -27).
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "serial/events.h"

namespace merker::serial {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kLongest = 1024;  // bytes of a telegram (PTP-OVW-03)

struct MailboxParameters {
  bool preventOverwriting = true;
  bool wholeBuffer = true;
  std::uint8_t telegrams = 10;  // at most so many, if not the whole buffer is used
  bool clearAtStart = false;
};

// Who takes the telegrams of a procedure.
class Inbox {
 public:
  virtual ~Inbox() = default;
  virtual bool free() const = 0;  // for a further telegram
  // None: taken; else why not.
  virtual Event put(Bytes telegram) = 0;
  virtual void report(Event event) = 0;
};

class Mailbox : public Inbox {
 public:
  static constexpr std::size_t kSize = 2048, kEvents = 16, kTwoThirds = 1366;

  explicit Mailbox(const MailboxParameters& parameters = {}) : parameters_(parameters) {}

  bool free() const override;
  Event put(Bytes telegram) override;
  void report(Event event) override;

  // What comes next for the program: a telegram, or an error or warning without data.
  struct Entry {
    Event event = Event::None;
    Bytes telegram;
  };
  std::optional<Entry> take();
  void clear();                               // the telegrams; not the errors (PTP-SFB62-02)
  void refuse(bool now) { refusing_ = now; }  // nothing is stored (CPU in STOP)
  void start();                               // STOP to RUN

  std::size_t bytes() const { return bytes_; }
  std::size_t telegrams() const { return telegrams_; }
  bool countReached() const { return !parameters_.wholeBuffer && telegrams_ >= limit(); }

 private:
  std::size_t limit() const { return parameters_.telegrams; }
  bool fits(std::size_t bytes) const;
  void dropOldest();

  MailboxParameters parameters_;
  std::deque<Entry> entries_;
  std::deque<Event> urgent_;  // states of the buffer: shown before its contents
  std::size_t bytes_ = 0, telegrams_ = 0, events_ = 0;
  bool refusing_ = false, warned_ = false;
};

}  // namespace merker::serial
