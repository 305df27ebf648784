// The MC5 instruction set of SINUMERIK 810/820, described once: operations.inc (mnemonic, level,
// status effect, source) and encodings.inc (bit patterns, execution times). Assembler,
// disassembler, interpreter, tests and documentation read these rows.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "clock/instant.h"
#include "mc5/operand.h"

namespace merker::mc5 {

enum class Operation : std::uint8_t {
#define OPERATION(id, name, other, level, status, source) id,
#include "mc5/operations.inc"
#undef OPERATION
};

// Basic operations stand in every code block, supplementary ones in function blocks (S5-BLK-12).
enum class Level : std::uint8_t { Basic, Supplementary };

struct OperationInfo {
  std::string_view id, name, other;
  Level level;
  // Eight characters in the order ANZ1 ANZ0 OV OS OR STATUS VKE ERAB: - unchanged, 0 1 fixed, x by
  // result.
  std::string_view status;
  std::string_view source;
};

const OperationInfo& info(Operation operation);
std::span<const OperationInfo> operations();

struct Instruction {
  Operation operation = Operation::NOP0;
  Operand operand;
  bool operator==(const Instruction&) const = default;
};

// Binary instructions run in the coprocessor of either variant, word instructions in that of the
// ACOP (1.1, S5-OPC-07).
enum class Variant : std::uint8_t { Cop, Acop };

// Execution time. The shortest is that of an instruction that is not executed or has nothing to do
// (S5-OPC-04).
struct Times {
  Duration shortest, longest;
};

struct Encoding;  // a row of encodings.inc

struct Decoded {
  Instruction instruction;
  const Encoding* encoding = nullptr;
  unsigned words = 1;  // 1..3
};

std::span<const Encoding> encodings();

// Appends the code of the instruction. False if no row has this operation with this operand or the
// operand does not fit its field; `out` is then unchanged. Limits of the PLC are not looked at:
// see range.h.
[[nodiscard]] bool encode(const Instruction& instruction, std::vector<std::uint16_t>& out);
// With this row and no other: the inverse of decode.
[[nodiscard]] bool encode(const Encoding& row, const Operand& operand,
                          std::vector<std::uint16_t>& out);
// The instruction at the start of `code`; nothing if no row fits or it is cut off.
std::optional<Decoded> decode(std::span<const std::uint16_t> code);
// Whether any row begins with this word.
bool beginsInstruction(std::uint16_t word);

Times times(const Encoding& row, Variant variant);

// "U     E 0.0". A jump shows its distance in words ("SPA   =+4"), a formal operand its index
// ("U     =1").
std::string text(const Instruction& instruction);

}  // namespace merker::mc5
