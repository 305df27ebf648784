// expect serial X27 received BYTES: what has arrived at the partner and was not expected yet; then
// it is taken.
#pragma once

#include "plc/controller.h"
#include "scenario/claim.h"
#include "scenario/step_binding.h"
#include "scenario/step_line.h"
#include "serial/rk512.h"
#include "serial/serial_port.h"

namespace merker::simulator::expectations {

struct Serial {
  using Needs = serial::SerialPort;
  static constexpr bool kSpeaksOfState = false;

  enum class Of : std::uint8_t { Received, Memory, Ended };
  Of of = Of::Received;
  std::string port;
  Position portPosition;
  serial::Bytes bytes;    // empty: nothing
  serial::LinkJob job;    // Memory
  serial::Event event{};  // Ended

  bool parse(const StepLine& line, const Claim& claim);
  void resolve(const StepBinding& binding);
  bool holds(controller::Controller& plc) const;
  std::string actual(controller::Controller& plc) const;
};

}  // namespace merker::simulator::expectations
