// The operands of AWL text that a symbol table can name.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "source/symbol_table.h"

namespace merker::exporting {

struct Operand {
  std::size_t begin = 0, end = 0;
  std::string symbol;                            // of "Motor"; empty:
  std::optional<source::SymbolAddress> address;  // of E 1.0, DB 5
  bool member = false;                           // a variable follows: "Motor".speed, DB5.speed
  bool absoluteData = false;                     // DB5.DBW 2
  bool pointer = false;                          // within [ ]
};

// Those between two places of a source, in their order. Comments, texts, titles, constants and
// names of parameters (x := ) are none.
void eachOperand(std::string_view text, std::size_t begin, std::size_t end,
                 const std::function<void(const Operand&)>& visit);

}  // namespace merker::exporting
