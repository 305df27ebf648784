// The declaration that a new organization block begins with: its start information by name, as
// STEP 7 writes it.
#pragma once

#include <cstdint>
#include <string>

namespace merker::workbench {

// "VAR_TEMP ... END_VAR", the 20 bytes in front of the block's own temporary variables.
std::string startDeclaration(std::uint32_t ob);

}  // namespace merker::workbench
