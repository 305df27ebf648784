// Text in a code page of DOS, as STEP 5 keeps it on disks.
#pragma once

#include <string>
#include <string_view>

#include "base/text.h"

namespace merker::source {

// One byte a character, '?' where the code page (Cp437, Cp850) has none.
std::string toDos(std::string_view utf8, Encoding codePage);

}  // namespace merker::source
