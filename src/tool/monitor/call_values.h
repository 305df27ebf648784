// What the registers do not say about a statement: what was given to the parameters of a CALL and
// what came back, as the program status shows it at the pins of a box; behind S, R, FP and FN the
// local bit itself.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "address/reference.h"
#include "block/block.h"
#include "monitor/code.h"
#include "scenario/term.h"

namespace merker::monitor {

// An elementary parameter with an operand whose value can be read.
struct ActualOperand {
  std::string parameter;
  bool output = false;             // read behind the call, otherwise before it
  TypeCode type = TypeCode::Void;  // of the parameter
  std::string local;               // a variable of the calling block; empty: `reference`
  address::Reference reference;
};

struct CallValues {
  std::uint32_t first = 0, last = 0;  // offsets of the first and the last instruction of the CALL
  std::vector<ActualOperand> operands;
  std::vector<std::optional<std::uint32_t>> values = {};  // of the last pass; one for each operand
};

// Of a block of STEP 7, as many statements as have operands of this kind; the bit of S, R, FP and
// FN is an output by its own name.
std::vector<CallValues> callsOf(const BlockCode& code, const block::Program& program,
                                const block::Program& library, const simulator::Resolver& resolver);

}  // namespace merker::monitor
