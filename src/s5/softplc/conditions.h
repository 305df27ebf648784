// Conditions around the PLC that are alarms when they begin (S5-ERR-02).
#pragma once

#include <bitset>
#include <functional>

#include "softplc/alarm.h"
#include "softplc/processor.h"
#include "softplc/surroundings.h"

namespace merker::sinumerik {

class Conditions {
 public:
  // The alarm of a condition that has begun, and its control bit beside the alarm's own. False: the
  // rest is looked at by the next call.
  using Begins = std::function<bool(Alarm alarm, ControlBit also)>;

  void forget() { holding_.reset(); }
  // `withUnit`: also those of the distributed unit. `macros` may be null.
  void look(const Surroundings& around, const Macros* macros, bool withUnit, const Begins& begins);

 private:
  std::bitset<8> holding_;  // as last seen
};

}  // namespace merker::sinumerik
