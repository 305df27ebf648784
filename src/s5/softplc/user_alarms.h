// User alarms 6000..6063 and messages 7000..7063: 64 bits each, where the project says (OP-55).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "softplc/alarm_list.h"
#include "softplc/machine.h"

namespace merker::sinumerik {

// 64 bits from a flag byte, or from a data word (bit 0 of the low byte first) if `db` is not 0.
struct BitField {
  std::uint16_t db = 0;
  std::uint32_t first = 0;
};

struct UserAlarms {
  std::optional<BitField> alarms, messages;
  std::map<unsigned, std::string> texts;  // by alarm number
};

// Takes the bits over into the list: a bit that is set makes its alarm pending, one that is reset
// withdraws it.
void showUserAlarms(const UserAlarms& configured, const Machine& machine, AlarmList& list);

}  // namespace merker::sinumerik
