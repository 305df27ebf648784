// What the programmer of a PLC shows beyond what every controller can tell (S5-ERR-06): the screens
// of a STOP.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "plc/capability.h"

namespace merker::controller {

class StopScreens : public Capability {
 public:
  static constexpr std::string_view kName = "screens of a STOP";

  // A field of a stack, "USTACK" or "BSTACK", as on its screen. Nothing if there is no such field.
  virtual std::optional<std::string> stackField(std::string_view stack,
                                                std::string_view field) const = 0;
  // The names of the fields, for problems.
  virtual std::string stackFields(std::string_view stack) const = 0;
  // The place and the registers of a STOP in one line; empty while there is none.
  virtual std::string stopDetails() const = 0;
};

}  // namespace merker::controller
