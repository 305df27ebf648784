// What the screen of the control shows of the PLC: pending alarms in the order of time, and the
// history of events with their times (S5-ERR-04, S5-ERR-05).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clock/instant.h"

namespace merker::sinumerik {

constexpr unsigned kPlcStop = 3;  // alarm 3 "PLC-Stop"

struct PendingAlarm {
  unsigned number = 0;
  Instant time;
  std::string text;
  bool stops = false;  // stays until the next start
};

// One event; number 0: a change of the operating state.
struct DiagnosticEntry {
  unsigned number = 0;
  Instant time;
  std::string text;
};

class AlarmList {
 public:
  // False: it is pending already. `announce` writes it into the history, too.
  bool add(unsigned number, std::string text, Instant now, bool stops);
  bool announce(unsigned number, std::string text, Instant now, bool stops);
  // Quits a message; the alarms of a STOP stay.
  bool acknowledge(unsigned number);
  void withdraw(unsigned number);
  void clear() { pending_.clear(); }
  bool pending(unsigned number) const;
  // As on the screen: alarm 3 first, then by time.
  std::vector<PendingAlarm> shown() const;

  void note(unsigned number, std::string text, Instant now);
  const std::vector<DiagnosticEntry>& history() const { return history_; }

 private:
  std::vector<PendingAlarm> pending_;
  std::vector<DiagnosticEntry> history_;  // newest last
};

}  // namespace merker::sinumerik
