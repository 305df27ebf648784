// Declarations of an interface that has no text.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "block/block.h"

namespace merker::awl {

// VAR_INPUT … END_VAR for a code block, STRUCT … END_STRUCT for a data block. The return value of a
// function is not declared here.
std::string declarationText(const block::Block& block);

// "INT", "ARRAY [1..2] OF STRUCT …"; of an UDT its structure.
std::string typeText(const block::Type& type);

// An elementary value, a DATE_AND_TIME or a STRING from its bytes, as a constant of its type; empty
// for other types.
std::string valueText(const block::Type& type, std::span<const std::uint8_t> bytes, unsigned bit);

}  // namespace merker::awl
