// A PLC that checks program and data when it starts: what it finds wrong is an alarm (S5-ERR-01).
// Such a start was not refused, it failed.
#pragma once

#include "plc/capability.h"

namespace merker::controller {

class CheckedStart : public Capability {
 public:
  static constexpr std::string_view kName = "check at the start";

  // After settle(): the last start led into STOP by an alarm, or its OB does not end.
  virtual bool startFailed() const = 0;
};

}  // namespace merker::controller
