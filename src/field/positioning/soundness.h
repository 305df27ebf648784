// Whether the parameters of an axis fit together; the CPU takes no others (POS-PARAM-29).
#pragma once

#include <optional>
#include <string_view>

#include "io/axis_channel.h"

namespace merker::positioning {

// The first rule that is broken, as a sentence; nothing if all hold.
std::optional<std::string_view> flaw(const io::AxisChannel& axis);

}  // namespace merker::positioning
