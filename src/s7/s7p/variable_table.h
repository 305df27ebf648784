// Variable tables (VAT) of a block folder: row 27.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/code_page.h"

namespace merker::s7p {

struct VariableTable {
  std::uint16_t number = 0;
  std::vector<std::string> operands;  // "MW 10", "DB5.DBX 0.1"; German
  unsigned unknown = 0;               // rows of another form
};

// The rows of MC5CODE: numbers with blanks between, ended by NUL; the first row is a header.
VariableTable readVariableTable(std::uint16_t number, std::span<const std::uint8_t> rows);

}  // namespace merker::s7p
