// What may stand behind a statement or an operand on its line.
#pragma once

#include "step5/operand.h"

namespace merker::step5 {

// Nothing or a comment. A comment begins with "!", ";" or "//"; free text counts as one where the
// printed listings do it, behind a blank, unless it reads like another operand or statement.
bool commentFollows(Scanner& scanner, Failure& failure);

}  // namespace merker::step5
