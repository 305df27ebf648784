// Constants and data of the NC as scenarios, traces and the command line name them; operands: see
// step5/variable.h.
#pragma once

#include <optional>
#include <string_view>

#include "address/constant.h"
#include "address/reference.h"

namespace merker::cnc {

// "nc.R 50": a datum of the NC; nothing if there is none of this name.
std::optional<address::Reference> datumReference(std::string_view text);
// KH 7F0A, KF +5, KT 010.2 …; nothing if the text is no constant of STEP 5.
std::optional<Constant> parseConstant(std::string_view text);

}  // namespace merker::cnc
