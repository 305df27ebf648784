// Everything that is set for the sub-module PtP, its defaults and its limits (technology
// manual 6.3; PTP-PARAM).
#pragma once

#include <string>
#include <vector>

#include "serial/ascii.h"
#include "serial/procedure.h"
#include "serial/settings.h"

namespace merker::serial {

enum class Protocol : std::uint8_t { Ascii, Procedure, ComputerLink };

struct Parameters {
  Protocol protocol = Protocol::Ascii;
  bool diagnosticInterrupt = false;
  bool discardInStop = false;  // reaction to CPU STOP: STOP
  Settings line;
  AsciiParameters ascii;
  ProcedureParameters procedure;
  MailboxParameters mailbox;
  // Of the simulator: characters take the time of their rate, or none to speak of (PTP-LINE-07).
  bool paced = true;
};

// What a protocol begins with. The preset follows the mode (PTP-PARAM-25), the acknowledgement
// delay the block check (PTP-PARAM-28, -29).
Parameters defaults(Protocol protocol);
Preset defaultPreset(Mode mode);
Duration defaultAcknowledgeDelay(bool blockCheck);

// The shortest times at a rate (PTP-PARAM-13, -30, -31).
Duration leastCharacterDelay(Protocol protocol, std::uint32_t baud);
// The next time that can be set: on the grid, within the limits (PTP-PARAM-36).
Duration settable(Protocol protocol, std::uint32_t baud, Duration time);

struct Refusal {
  std::string_view parameter;
  std::string text;
};
// What cannot be set so; empty if all is well.
std::vector<Refusal> check(const Parameters& parameters);

}  // namespace merker::serial
