// What programming devices ask of a CPU, in its thread. A machine that has nothing of the kind
// refuses.
#pragma once

#include "monitor/monitor.h"
#include "s7comm/plc.h"
#include "served/resources.h"
#include "system/communication.h"

namespace merker::served {

s7comm::StatusList statusList(controller::Controller& plc, std::uint16_t list, std::uint16_t index);
// What its lists say of connections, and of the interface they come by.
void setConnections(controller::Controller& plc, const Resources::Counts& inUse,
                    const std::optional<system::EthernetInterface>& ethernet);
void setTestJobs(controller::Controller& plc, std::size_t jobs);
std::optional<s7comm::ClockTime> clockOf(controller::Controller& plc);
s7comm::Error setClock(controller::Controller& plc, const s7comm::ClockTime& time,
                       std::string_view password = {});
// Whether it is the one of the CPU.
s7comm::Error checkPassword(controller::Controller& plc, std::string_view password);
// Protection levels 2 and 3 refuse what is more than reading and writing variables, level 3 also to
// read more (S7-MEM-05).
bool isProtected(controller::Controller& plc, std::string_view password, int level = 2);
// Whether blocks may be changed: also not while the mode switch is at RUN (S7-SIM-11).
bool mayLoad(controller::Controller& plc, std::string_view password);
s7comm::Controlled control(monitor::Monitor& monitor, s7comm::Control wish,
                           std::string_view password = {});

}  // namespace merker::served
