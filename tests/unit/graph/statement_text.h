// Statements of a network in German mnemonics on one line: "U E 0.0; U(; O M 1.0; ); = A 4.0".
#pragma once

#include <string>

#include "graph/statement.h"

namespace merker::graph::test {

// L 20.0 and above are temporary bits; `->5` behind SPBNB: number of the statement that it leads
// to.
Statements statements(const std::string& text);
std::string text(const Statements& statements);
Operand operand(const std::string& text);

}  // namespace merker::graph::test
