// Mnemonics as text: reading them, which setting a source uses, and which constants they take.
#pragma once

#include <string>
#include <vector>

#include "mc7/instruction.h"
#include "step7/block_source.h"
#include "step7/cursor.h"
#include "step7/operand_parser.h"

namespace merker::step7 {

// The mnemonic at the cursor in upper case: "U(", "==I", "+AR1", "RND-", ")MCR", "NOP 0"; the
// bracket is taken.
std::string readMnemonic(Cursor& cursor);

bool worksWithoutOperand(mc7::Operation operation);
bool isJump(mc7::Operation operation);

// The constant as the operation takes it: SLW 4, UW W#16#F0F0, + L#5, BLD 7. Problem if it is out
// of range.
mc7::Operand fittedConstant(mc7::Operation operation, mc7::Operand operand, const Position& place,
                            Problems& problems, Limits limits = Limits::OfLanguage);

}  // namespace merker::step7
