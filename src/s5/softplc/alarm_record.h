// What alarms leave behind for those who look at the PLC: the list on the screen, the fine coding,
// the control bits, and of a STOP its pictures and its reason (S5-ERR-04 … -11).
#pragma once

#include <array>
#include <optional>
#include <string>

#include "softplc/alarm_list.h"
#include "softplc/interrupt_stack.h"
#include "softplc/operating_state.h"
#include "softplc/surroundings.h"
#include "softplc/trap.h"

namespace merker::sinumerik {

// Pseudo addresses F000 … F005 (S5-ERR-11).
struct FineCode {
  std::uint16_t code = 0;    // 00xx: FEHLCODE, 0 without STOP
  std::uint16_t number = 0;  // 61yy in BCD
  std::array<std::uint16_t, 3> words{};
  std::uint16_t delays = 0;  // zob2
};

class AlarmRecord {
 public:
  // A picture shows the machine as it stands then.
  AlarmRecord(const Machine& machine, const Surroundings& around);

  // A start forgets the last STOP; a cold start the fine coding, too.
  void begin(Start kind);
  void powerOff();
  void run() { note("RUN"); }
  // An alarm with its fine coding: a message, or the reason of a STOP.
  void message(const Trap& trap);
  void stop(const Trap& trap, ControlBit also, bool startUp);
  // A STOP for an event that has no number of its own.
  void stopWithout(std::string text);
  // STP: the cycle is finished first, but the STOP shows the machine as it is now.
  void keepPicture();
  void delayed() { ++fineCode_.delays; }
  void set(ControlBit bit, bool on = true) { controlBits_.set(bit, on); }

  const FineCode& fineCode() const { return fineCode_; }
  const StopPicture& picture() const { return picture_; }
  const ControlBits& controlBits() const { return controlBits_; }
  const std::string& reason() const { return reason_; }
  bool byFault() const { return byFault_; }
  AlarmList& alarms() { return alarms_; }
  const AlarmList& alarms() const { return alarms_; }

 private:
  void code(const Trap& trap, bool stops);
  void note(std::string text);  // a change of the operating state
  std::string place() const;
  StopPicture pictureNow() const;

  const Machine& machine_;
  const Surroundings& around_;
  AlarmList alarms_;
  FineCode fineCode_;
  StopPicture picture_;
  std::optional<StopPicture> kept_;
  ControlBits controlBits_;
  std::string reason_;
  bool byFault_ = false;
};

}  // namespace merker::sinumerik
