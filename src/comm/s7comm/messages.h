// Indications of messages (group 4), and of operating modes (group 0), as they are sent. Layout:
// Wireshark's dissector. A PLC makes them in its thread.
#pragma once

#include "s7comm/outlet.h"
#include "s7comm/plc.h"

namespace merker::s7comm {

// The operating mode that begins.
enum class ModeCode : std::uint8_t {
  Stop = 0,
  WarmRestart = 1,
  Run = 2,
  HotRestart = 3,
  Hold = 4,
  ColdRestart = 6
};
Indication modeIndication(ModeCode mode);

// An entry of the diagnostic buffer: 20 octets.
Indication diagnosticIndication(View entry);
// Its signal has come or gone; or it has been acknowledged, at this time.
Indication alarmIndication(const AlarmState& alarm);
Indication acknowledgementIndication(const AlarmState& alarm, const ClockTime& time);

}  // namespace merker::s7comm
