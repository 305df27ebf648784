// The sequence that STEP 7 makes of a CALL, back to the CALL.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "awl/names.h"
#include "awl/statements.h"
#include "mc7/listing.h"

namespace merker::awl {

// Number of instructions of the bracket that begins at `at` (BLD 1 … BLD 2 and the like); 0 if none
// does, or it has no end before `end`.
std::size_t callLength(const mc7::Listing& listing, std::size_t at, std::size_t end);

// "CALL FC 1 (", "IN := M 0.0,", ")". Empty if the bracket has another form than the known ones.
std::vector<std::string> callText(const mc7::Listing& listing, std::size_t at, std::size_t count,
                                  const Names& names, const Blocks& blocks, Mnemonics mnemonics);

// "P#M 50.0" or a number.
std::string parameterEntry(std::span<const std::uint8_t> entry);

}  // namespace merker::awl
