// Codes of number formats: the lists of parameters and the pre-headers have each their own.
#pragma once

#include <cstdint>
#include <span>

#include "mc5/constant.h"

namespace merker::s5d {

struct FormatCode {
  std::uint8_t code;
  mc5::Format format;
};

}  // namespace merker::s5d
