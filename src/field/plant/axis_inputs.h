// What the power section of an axis gets from the terminals of a CPU, and what it makes of it.
#pragma once

#include <cstdint>

namespace merker::plant {

struct AxisInputs {
  std::int64_t nanovolts = 0;              // AO 0; 20 mA are 10 V
  bool enable = false, direction = false;  // CONV_EN, CONV_DIR
  std::uint8_t contactors = 0;             // Q0 is bit 0
};

enum class PowerSection : std::uint8_t { Bipolar, WithDirection, Contactors };
enum class Stage : std::uint8_t { Off, CreepPlus, CreepMinus, RapidPlus, RapidMinus };

// By the contactors of a control type, 1 to 4; combinations that are not printed move nothing.
Stage stageOf(std::uint8_t controlType, std::uint8_t contactors);

}  // namespace merker::plant
