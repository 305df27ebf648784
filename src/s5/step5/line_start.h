// What a line of a code block begins with before its statement: nothing but a comment, the address
// that programmers print, a comment that goes on from the line above.
#pragma once

#include "step5/scanner.h"

namespace merker::step5 {

// Nothing or a comment: "!", ";", "*", "//".
bool isComment(const Scanner& scanner);

// "***": the end of a network.
bool isNetworkEnd(std::string_view line);

// Steps over "0005", a word address in front of a statement or label, with the blanks behind it.
void skipAddress(Scanner& scanner);

// Behind the colon, `blanks` columns of it: text of the line above that goes on, as the printed
// listings have it: (WZ-Korrektur lesen), "NSBY" vom …, or anything in the column of comments that
// is no statement.
bool continuesComment(const Scanner& scanner, std::size_t blanks);

}  // namespace merker::step5
