#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

constexpr std::size_t kWidths = 4;

constexpr Rows (*kFamilies[])() = {
    bitLogicRows,  statusBitRows, bracketRows,       bitOutputRows, edgeRows,
    timerRows,     counterRows,   loadRows,          transferRows,  addressRegisterRows,
    dataBlockRows, integerRows,   doubleIntegerRows, realRows,      realFunctionRows,
    compareRows,   wordLogicRows, shiftRows,         rotateRows,    accumulatorRows,
    convertRows,   roundRows,     jumpRows,          callRows,      mcrRows};

}  // namespace

std::size_t HandlerTable::index(mc7::Operation operation, Form form, Width width) {
  return (static_cast<std::size_t>(operation) * static_cast<std::size_t>(Form::Count) +
          static_cast<std::size_t>(form)) *
             kWidths +
         static_cast<std::size_t>(width);
}

HandlerTable::HandlerTable()
    : handlers_(mc7::operations().size() * static_cast<std::size_t>(Form::Count) * kWidths) {
  for (const auto family : kFamilies)
    for (const HandlerRow& row : family())
      for (const Width width : {Width::Bit, Width::Byte, Width::Word, Width::DWord})
        if (!row.width || *row.width == width)
          handlers_[index(row.operation, row.form, width)] = row.handler;
}

Handler HandlerTable::find(mc7::Operation operation, Form form, Width width) const {
  return handlers_[index(operation, form, width)];
}

}  // namespace merker::interpreter
