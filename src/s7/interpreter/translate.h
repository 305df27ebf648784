// Machine code to ops: each instruction of a block once, before it runs.
#pragma once

#include <span>

#include "interpreter/handlers.h"
#include "interpreter/translated.h"

namespace merker::interpreter {

// Where each instruction begins: op number by word of the code, -1 inside an instruction or a
// parameter list.
using OpByWord = std::vector<std::int32_t>;

class Translator {
 public:
  Translator(const HandlerTable& handlers, const CpuModel& model)
      : handlers_(handlers), model_(model) {}
  // Fills ops, instructionCount and parameters; any bytes are welcome.
  OpByWord translate(std::span<const std::uint8_t> code, Translated& out) const;
  Op makeOp(const mc7::Instruction& instruction, std::uint32_t offset) const;

 private:
  Form formOf(const mc7::Instruction& instruction, Op& op) const;
  Form directForm(Op& op) const;

  const HandlerTable& handlers_;
  const CpuModel& model_;
};

// What its instructions look at that is no memory: times of timers, in OB 1 the date in its local
// data (cpu/outlook.h). Reads through a pointer with its own area are seen when they happen.
std::vector<cpu::Look> looksOf(const Translated& code);

// Bytes of local data that instructions of the block reach directly.
std::uint32_t localUse(const Translated& code);

}  // namespace merker::interpreter
