// Why the processor stopped: the alarm number and the words of the fine coding (S5-ERR-11 … -15).
#pragma once

#include <array>
#include <cstdint>

#include "softplc/alarm.h"

namespace merker::sinumerik {

struct Trap {
  Alarm alarm = Alarm::IllegalCode;
  std::array<std::uint16_t, 3> words{};  // xxx1 … xxx3
};

}  // namespace merker::sinumerik
