// Events made by hand, as a simulator offers them (S7-SIM-13): OB 40 and the asynchronous errors.
#pragma once

#include <cstdint>

namespace merker::cpu {

class Cpu;

struct Trigger {
  std::uint8_t ob = 40;
  bool going = false;         // OB 81 to 84, 86: the fault has gone
  std::uint16_t address = 0;  // OB 40, 82, 83, 86: of the module
  std::uint32_t points = 1;   // OB 40: a bit for each channel; OB 86: for each rack
  std::uint32_t data = 0;     // OB 82: bytes 8..11 of the start information
  std::uint8_t fault = 0;     // FLT_ID of OB 80, 81, 84, 85, 87; 0: the usual one
};

// Whether there is such an event.
bool canTrigger(std::uint32_t ob);
// As if it had happened: entry, OB or STOP.
void trigger(Cpu& cpu, const Trigger& event);

}  // namespace merker::cpu
