// A restart that goes on from where STOP came (OB 101).
#pragma once

#include "plc/capability.h"

namespace merker::controller {

class HotRestart : public Capability {
 public:
  static constexpr std::string_view kName = "hot restart";

  virtual bool hasHotRestart() const = 0;  // this model
  virtual bool hotRestart() = 0;           // false: nothing was interrupted, or the model has none
};

}  // namespace merker::controller
