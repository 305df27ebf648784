// The statements of a network in the words of no family. A family turns its machine code into them
// and back; what lies between (operands reached by several instructions, CALL) is its own affair.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace merker::graph {

enum class Op : std::uint8_t {
#define OPERATION(id) id,
#include "graph/operations.inc"
#undef OPERATION
};

std::string_view name(Op op);  // "AND_BEFORE_OR"
std::optional<Op> findOp(std::string_view name);
bool isJump(Op op);  // to a label

enum class OperandKind : std::uint8_t {
  None,
  Bit,     // E 0.0, also a timer or counter as a contact
  Wire,    // a temporary bit behind the declared ones: number = its bit address
  Value,   // what L and T name: MW 10, a constant
  Number,  // T 5, Z 5, DB 5, FC 5: what a box or coil is about
  Status,  // OV, BIE: number as in the machine code
  Label,   // where a jump leads: the beginning of a network, or inside this one (Statement::target)
  Count,   // BLD 102: number
  Forbidden  // what no picture shows: indirect and register addressing, a jump into a network
};

struct Operand {
  OperandKind kind = OperandKind::None;
  std::uint32_t number = 0;
  std::string code;  // what only the family reads
  std::string text;  // how it is written: "E 0.0", "DB5.DBX 1.0"
  bool operator==(const Operand& other) const {
    return kind == other.kind && number == other.number && code == other.code;
  }
};

// A parameter of CALL with what is given to it.
struct Argument {
  std::string name, text;
  bool output = false;
  std::int64_t wire = -1;  // bit address of the temporary bit that is given
  bool bit = false;        // a BOOL that is read: logic may be given
  bool operator==(const Argument&) const = default;
};

struct Statement {
  Op op = Op::OTHER;
  Operand operand;
  std::int32_t target = -1;         // of a jump inside the network: number of a statement
  std::vector<Argument> arguments;  // CALL
  bool intruded = false;            // a jump leads here that no box explains
  std::uint32_t offset = 0;         // where it begins in the code of its block
  bool operator==(const Statement& other) const {
    return op == other.op && operand == other.operand && target == other.target &&
           arguments == other.arguments;
  }
};

using Statements = std::vector<Statement>;

}  // namespace merker::graph
