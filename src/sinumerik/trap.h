// Why the processor stopped: the alarm number and the words of the fine coding (S5-ERR-11 … -15).
#pragma once

#include <array>
#include <cstdint>

namespace merker::sinumerik {

// Numbers of S5-ERR-T5 that instructions cause.
enum class Alarm : std::uint16_t {
  IllegalCode = 6101,
  IllegalParameter = 6102,
  TransferToMissingDb = 6103,
  Substitution = 6104,
  MissingBlock = 6105,
  MissingDb = 6106,
  SegmentLirTir = 6107,
  SegmentBlockTransfer = 6108,
  BlockStack = 6109,
  InterruptStack = 6110,
  Sts = 6111,
  Stp = 6112,
  TimerCounter = 6113,
  Macro = 6114,
  SystemCommandsLocked = 6115,
  NoAnswerLirTir = 6152,
  NoAnswerBlockTransfer = 6153,
  NoAnswerPeriphery = 6154
};

struct Trap {
  Alarm alarm = Alarm::IllegalCode;
  std::array<std::uint16_t, 3> words{};  // xxx1 … xxx3
};

}  // namespace merker::sinumerik
