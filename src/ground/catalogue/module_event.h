// What a module tells its CPU by itself: the modules (io) make these, the CPU answers with an OB.
#pragma once

#include <array>
#include <cstdint>

namespace merker {

struct ModuleEvent {
  enum class Kind : std::uint8_t {
    HardwareInterrupt,  // OB 40
    DiagnosticComing,   // OB 82
    DiagnosticGoing,    // OB 82
    Removed,            // OB 83, and access errors from then on
    Inserted,           // OB 83
    RackFailed,         // OB 86
    RackReturned,       // OB 86
    StationFailed,      // OB 86, of a DP slave
    StationReturned     // OB 86
  };
  Kind kind = Kind::HardwareInterrupt;
  std::uint16_t address = 0;  // logical start address of the module
  bool output = false;        // of a module that has only outputs (IO_FLAG 16#55)
  // POINT_ADDR of OB 40, a bit for each channel (S7-OBI-06); RACKS_FLTD of OB 86 (S7-OBI-11)
  std::uint32_t points = 0;
  std::array<std::uint8_t, 4> data{};  // bytes 8..11 of OB 82's start information (S7-OBI-09)
};

}  // namespace merker
