// A function block as one of its calls sees it: formal operands are what the parameter list behind
// that call names.
#pragma once

#include <cstdint>
#include <span>

#include "lowering5/translate.h"

namespace merker::cnc {

// `code`: of the function block, `parameters`: from the first word of the list on. What fits
// nothing, opens or calls a block is left out: that is the processor's.
translate5::Substitutes substitutes(std::span<const std::uint16_t> code,
                                    std::span<const std::uint16_t> parameters,
                                    mc5::Variant variant);

}  // namespace merker::cnc
