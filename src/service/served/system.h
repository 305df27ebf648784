// What programming devices ask of a CPU, in its thread. A machine that has nothing of the kind
// refuses.
#pragma once

#include "monitor/monitor.h"
#include "s7comm/plc.h"

namespace merker::served {

std::optional<s7comm::StatusList> statusList(controller::Controller& plc, std::uint16_t list,
                                             std::uint16_t index);
std::optional<s7comm::ClockTime> clockOf(controller::Controller& plc);
s7comm::Error setClock(controller::Controller& plc, const s7comm::ClockTime& time);
s7comm::Controlled control(monitor::Monitor& monitor, s7comm::Control wish);

}  // namespace merker::served
