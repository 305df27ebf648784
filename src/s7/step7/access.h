// An operand as the source names it, resolved to what the machine can address.
#pragma once

#include "block/block.h"
#include "mc7/instruction.h"

namespace merker::step7 {

struct Access {
  enum class Kind : std::uint8_t {
    Machine,     // `operand` as it stands, after AUF DB `openDb` if that is not -1
    Descriptor,  // part of a composite parameter: through the POINTER of parameter `descriptor`, at
                 // `operand.value`
    Number,      // TIMER, COUNTER, BLOCK_x of an FB: `operand` with the number that the instance
                 // holds for parameter `variable`, by way of a word of local data
    Address,     // P##name: `operand` is a constant or ParameterAddress
    BlockName    // FC 5, DB 3, "symbol of a block"
  } kind = Kind::Machine;
  mc7::Operand operand;
  std::int32_t openDb = -1;
  const block::Variable* descriptor = nullptr;  // the parameter whose POINTER is followed
  const block::Variable* variable = nullptr;    // local variable at the root of the name, if any
  block::TypePtr type;             // of a declared variable, null for an absolute operand
  bool peripheralOutput = false;   // PAB … instead of PEB …
  std::size_t begin = 0, end = 0;  // in the source
};

}  // namespace merker::step7
