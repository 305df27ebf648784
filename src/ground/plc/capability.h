// What only some PLCs can do: an interface of its own for each such thing. Whoever needs one asks
// the PLC for what it can do, never for its family.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <typeinfo>
#include <utility>

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

// Null: this PLC has none. A cast across the bases compares names of types, a quarter of the time
// of a scenario that looks at each cycle; so each thread keeps what the last PLC's type has.
template <IsCapability C>
const C* capability(const Controller& plc) {
  constexpr std::ptrdiff_t kNone = PTRDIFF_MIN;
  thread_local const std::type_info* type = nullptr;
  thread_local std::ptrdiff_t place = kNone;  // of C in that type, in bytes from its Controller
  const Controller& whole = plc.itself();
  const auto* const begin = reinterpret_cast<const std::byte*>(&whole);
  if (type != &typeid(whole)) {
    const auto* const found = dynamic_cast<const C*>(&whole);
    place = found == nullptr ? kNone : reinterpret_cast<const std::byte*>(found) - begin;
    type = &typeid(whole);
  }
  return place == kNone ? nullptr : reinterpret_cast<const C*>(begin + place);
}
template <IsCapability C>
C* capability(Controller& plc) {
  return const_cast<C*>(capability<C>(std::as_const(plc)));
}

}  // namespace merker::controller
