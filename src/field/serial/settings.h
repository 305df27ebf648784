// How an interface X27 is wired and set (technology manual 6.3.4, 6.3.5).
#pragma once

#include <cstdint>

#include "serial/frame.h"

namespace merker::serial {

enum class Mode : std::uint8_t {
  PointToPoint,      // RS 422, four wires
  MultipointMaster,  // RS 422: its sender drives the receivers of all slaves
  MultipointSlave,   // RS 422: its sender is off between telegrams; never a CPU 31xC (PTP-PHY-18)
  TwoWire            // RS 485, half duplex
};

// What the receiver sees while nobody drives the line (PTP-PHY-17).
enum class Preset : std::uint8_t {
  None,
  Break,  // R(A) 5 V / R(B) 0 V: an open line is a BREAK
  Idle    // R(A) 0 V / R(B) 5 V
};

struct Settings {
  std::uint32_t baud = 9600;
  Frame frame{};
  Mode mode = Mode::PointToPoint;
  Preset preset = Preset::Break;
};

// From sending to receiving (RS 485): at most 1 ms; who answers after 1 ms is heard (PTP-PHY-05).
constexpr Duration kChangeOver = Duration::microseconds(990);

}  // namespace merker::serial
