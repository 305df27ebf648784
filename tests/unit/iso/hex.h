// A connection request and its confirmation.
#pragma once

#include "../hex.h"
#include "iso/tpdu.h"

namespace merker::iso {

// What S7 clients ask with: TPDU size 1024, TSAPs of a PG and of rack 0 slot 2.
constexpr std::string_view kRequest =
    "03 00 00 16 11 E0 00 00 00 05 00 C0 01 0A C1 02 01 00 C2 02 01 02";
constexpr std::string_view kConfirm =
    "03 00 00 16 11 D0 00 05 00 01 00 C0 01 0A C1 02 01 00 C2 02 01 02";

}  // namespace merker::iso
