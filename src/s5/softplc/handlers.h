// One handler per operation; each file of instructions gives its rows.
#pragma once

#include <span>

#include "softplc/processor.h"

namespace merker::sinumerik {

struct HandlerRow {
  mc5::Operation operation;
  Handler handler;
};
using HandlerRows = std::span<const HandlerRow>;

HandlerRows bitHandlers();
HandlerRows loadHandlers();
HandlerRows cellHandlers();
HandlerRows compareHandlers();
HandlerRows arithmeticHandlers();
HandlerRows floatHandlers();
HandlerRows wordHandlers();
HandlerRows conversionHandlers();
HandlerRows callHandlers();
HandlerRows jumpHandlers();
HandlerRows processingHandlers();
HandlerRows systemHandlers();

// The handler of an instruction; formal operands go to substitution.
Handler handler(const mc5::Instruction& instruction);
bool substituteFormal(Processor& p, const mc5::Instruction& instruction);

}  // namespace merker::sinumerik
