// What modules and the power supply tell the CPU: OB 40, 81, 82, 83, 86 (S7-BLK-11, S7-OBI-06, -08,
// -09, -11; S7-ERR-05).
#pragma once

#include <vector>

#include "catalogue/module_event.h"
#include "cpu/requests.h"

namespace merker::cpu {

class ModuleEvents {
 public:
  struct Parts {
    EventLog& log;
    Modules& modules;
    StateControl& state;
    Requests& requests;
    PresentFaults& faults;
  };
  // `interrupts`: which OBs are locked.
  ModuleEvents(const Machine& machine, const Interrupts& interrupts, const Parts& parts)
      : machine_(machine), interrupts_(interrupts), parts_(parts) {}
  void happened(const ModuleEvent& event);
  void setBattery(bool low);  // OB 81
  // OB 40 has ended: its module may report again.
  void hardwareInterruptEnded(const StartInformation& ended);

  // Edges of modules whose OB 40 has not ended yet.
  const std::vector<ModuleEvent>& stored() const { return stored_; }
  void clear() { stored_.clear(); }

 private:
  void hardwareInterrupt(const ModuleEvent& event);
  bool busy(const ModuleEvent& event) const;
  void store(const ModuleEvent& event, const StartInformation& start);

  const Machine& machine_;
  const Interrupts& interrupts_;
  Parts parts_;
  std::vector<ModuleEvent> stored_;
};

}  // namespace merker::cpu
