// The handlers of all instructions. Each family has one file with its rows; together they are the
// table from operation, form and width to a handler.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "interpreter/form.h"
#include "interpreter/op.h"

namespace merker::interpreter {

struct HandlerRow {
  mc7::Operation operation;
  Form form = Form::None;
  Handler handler = nullptr;
  std::optional<Width> width{};  // nothing: any
};

using Rows = std::vector<HandlerRow>;
Rows bitLogicRows();
Rows statusBitRows();
Rows bracketRows();
Rows bitOutputRows();
Rows edgeRows();
Rows timerRows();
Rows counterRows();
Rows loadRows();
Rows transferRows();
Rows addressRegisterRows();
Rows dataBlockRows();
Rows integerRows();
Rows doubleIntegerRows();
Rows realRows();
Rows realFunctionRows();
Rows compareRows();
Rows wordLogicRows();
Rows shiftRows();
Rows rotateRows();
Rows accumulatorRows();
Rows convertRows();
Rows roundRows();
Rows jumpRows();
Rows callRows();
Rows mcrRows();

class HandlerTable {
 public:
  HandlerTable();
  // Null: the machine has no such instruction.
  Handler find(mc7::Operation operation, Form form, Width width) const;

 private:
  static std::size_t index(mc7::Operation operation, Form form, Width width);
  std::vector<Handler> handlers_;
};

}  // namespace merker::interpreter
