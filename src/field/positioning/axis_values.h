// What can be looked at of an axis from outside, by name: `expect axis.position = 1000`.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "plc/capability.h"
#include "positioning/channel.h"

namespace merker::positioning {

struct AxisValue {
  std::string_view name;
  std::string_view unit;
  bool binary = false;
  std::int64_t (*read)(const Channel&, const Image&);
};

std::span<const AxisValue> axisValues();
const AxisValue* findAxisValue(std::string_view name);  // ignoring case
std::string axisValueNames();                           // for problems
std::int64_t read(const AxisValue& value, const Channel& channel);

// A PLC with a sub-module 2.5.
class AxisOwner : public controller::Capability {
 public:
  static constexpr std::string_view kName = "positioning axis";

  virtual const Channel* axis() const = 0;  // null: none is configured
};

}  // namespace merker::positioning
