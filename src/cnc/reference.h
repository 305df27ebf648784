// Operands of STEP 5 as the references that scenarios, traces and the command line hold, and back.
#pragma once

#include <optional>
#include <string_view>

#include "address/constant.h"
#include "mc5/variable.h"
#include "mc7/reference.h"

namespace merker::cnc {

// E 0.0, MW 10, T 5, DB10.DW 5 … A data word is two bytes of the data block, the left one first.
mc7::Reference toReference(std::string_view text, const mc5::Variable& variable);
// "nc.R 50": a datum of the NC; nothing if there is none of this name.
std::optional<mc7::Reference> datumReference(std::string_view text);
// KH 7F0A, KF +5, KT 010.2 …; nothing if the text is no constant of STEP 5.
std::optional<Constant> parseConstant(std::string_view text);
// Nothing for a reference that no operand of STEP 5 stands behind.
std::optional<mc5::Variable> toVariable(const mc7::Reference& reference);

}  // namespace merker::cnc
