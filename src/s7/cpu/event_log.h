// The diagnostic buffer as the operating system writes it (S7-DIAG-01 … -03): each entry gets the
// time, its place in the program, and the priority class and OB that ran.
#pragma once

#include <string>

#include "cpu/diagnostics.h"
#include "cpu/event.h"
#include "cpu/machine.h"
#include "cpu/real_time_clock.h"
#include "cpu/start_information.h"

namespace merker::cpu {

class EventLog {
 public:
  EventLog(const Machine& machine, const RealTimeClock& clock) : machine_(machine), clock_(clock) {}
  const Diagnostics& buffer() const { return buffer_; }
  DateAndTime dateAndTime() const;
  // The instruction that calls or fails; unknown between two OBs.
  Place here() const;

  void report(Event event, Place place = {});
  void report(Event event, std::string text);
  // An entry that says what the start information of an OB says.
  void report(const StartInformation& start, std::string text);
  // Of the user program or of a module; info: bytes 4..11 of the entry (S7-SFC-20).
  void note(std::uint16_t event, std::string text, const DiagnosticInformation& info);

  // An entry of now, to be added.
  DiagnosticEvent entry(std::uint16_t event, std::string text, Place place) const;
  void add(DiagnosticEvent event) { buffer_.add(std::move(event)); }
  void clear() { buffer_.clear(); }
  // These blocks have other code from now on.
  void replaced(const std::set<BlockId>& blocks) { buffer_.replaced(blocks); }

 private:
  const Machine& machine_;
  const RealTimeClock& clock_;
  Diagnostics buffer_;
};

}  // namespace merker::cpu
