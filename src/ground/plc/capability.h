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

// Null: this PLC has none.
template <IsCapability C>
C* capability(Controller& plc) {
  return dynamic_cast<C*>(&plc.itself());
}
template <IsCapability C>
const C* capability(const Controller& plc) {
  return dynamic_cast<const C*>(&plc.itself());
}

}  // namespace merker::controller
