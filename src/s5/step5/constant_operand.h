// Constants in a listing: KH 7F0A, KF+128, KC F1, KCTO, KT 010.2, KM 0011111001011011 …
#pragma once

#include <optional>

#include "step5/operand.h"

namespace merker::step5 {

// Whether a constant stands here: the word of a format (KH, BF …), also with its value right
// behind it.
bool isConstant(const Scanner& scanner);
// `equals`: "KH = 1F00", as data words are written, is taken too.
std::optional<Operand> parseConstant(Scanner& scanner, Failure& failure, bool equals = false);

}  // namespace merker::step5
