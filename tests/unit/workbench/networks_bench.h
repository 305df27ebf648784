// A text with networks, and requests about it.
#pragma once

#include "bench.h"

namespace merker::workbench::test {

// The worked example of the course (S7-EDIT-14) in a block with a network that stays AWL.
constexpr const char* kNetworks = R"(FUNCTION FC 1 : VOID
TITLE = Motor
BEGIN
NETWORK
TITLE = Start
// With self-holding
      U     E 0.0; // the button
      U     E 0.1;
      O     A 1.0;
      =     A 3.0;
NETWORK
      L     MW 2;
      TAK   ;
END_FUNCTION
)";

inline Json asked(const Json& more = Json::object()) {
  Json fields = {{"file", "fc1.awl"}, {"text", kNetworks}, {"line", 2}};
  fields.update(more);
  return fields;
}

}  // namespace merker::workbench::test
