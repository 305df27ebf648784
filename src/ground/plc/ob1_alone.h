// OB 1 without its operating system, for measurements.
#pragma once

#include "plc/capability.h"

namespace merker::controller {

class Ob1Alone : public Capability {
 public:
  static constexpr std::string_view kName = "OB 1 to measure";

  // Runs OB 1 once, without the operating system's share of the cycle and without cycle monitoring.
  // False if it did not end within `most`; the next call goes on with it then.
  virtual bool runOb1(Duration most) = 0;
};

}  // namespace merker::controller
