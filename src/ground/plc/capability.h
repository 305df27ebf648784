// What only some PLCs can do: an interface of its own for each such thing. Whoever needs one asks
// the PLC for what it can do, never for its family.
#pragma once

#include <concepts>
#include <string_view>

#include "plc/controller.h"

namespace merker::controller {

class Capability {
 public:
  virtual ~Capability() = default;

 protected:
  Capability() = default;
  Capability(const Capability&) = default;
  Capability& operator=(const Capability&) = default;
};

// It has a name for the message of a PLC that lacks it: "... has no mode switch".
template <typename C>
concept IsCapability = std::derived_from<C, Capability> && requires {
  { C::kName } -> std::convertible_to<std::string_view>;
};

// A PLC among others that move through time together: it is asked in place of the PLC itself, which
// has the capabilities.
class Deputy {
 public:
  virtual ~Deputy() = default;
  virtual Controller& itself() const = 0;
};

// Null: this PLC has none.
template <IsCapability C>
C* capability(Controller& plc) {
  const auto* const deputy = dynamic_cast<const Deputy*>(&plc);
  return dynamic_cast<C*>(deputy == nullptr ? &plc : &deputy->itself());
}
template <IsCapability C>
const C* capability(const Controller& plc) {
  const auto* const deputy = dynamic_cast<const Deputy*>(&plc);
  return dynamic_cast<const C*>(deputy == nullptr ? &plc : &deputy->itself());
}

}  // namespace merker::controller
