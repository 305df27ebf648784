// The S7 instruction set, described once: operations.inc (mnemonics, status effect, time class,
// source) and encodings.inc (bit patterns). Assembler, disassembler, interpreter, tests and
// documentation read these rows.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/cpu_model.h"
#include "mc7/operand.h"

namespace merker::mc7 {

enum class Operation : std::uint8_t {
#define OPERATION(id, de, en, status, time, source) id,
#include "mc7/operations.inc"
#undef OPERATION
};

struct OperationInfo {
  std::string_view id, de, en;
  // Nine characters in the order BIE A1 A0 OV OS OR STA VKE /ER: - unchanged, 0 1 fixed, x by
  // result.
  std::string_view status;
  TimeClass time;
  std::string_view source;
};

const OperationInfo& info(Operation operation);
std::span<const OperationInfo> operations();
// The operation of a mnemonic ("SPB", "JC"), upper case. Where German and international words
// differ in meaning (SE, UD/AD …) the setting decides.
std::optional<Operation> findOperation(std::string_view mnemonic, Mnemonics mnemonics);

struct Instruction {
  Operation operation = Operation::NOP0;
  Operand operand;
  bool operator==(const Instruction&) const = default;
};

struct Encoding;  // a row of encodings.inc

struct Decoded {
  Instruction instruction;
  const Encoding* encoding = nullptr;
  unsigned length = 2;  // bytes: 2, 4 or 6
};

// All encodings, in the order of preference: the short form first (MC7 section 10).
std::span<const Encoding> encodings();

// Appends the shortest code of the instruction. False if no row has this operation with this
// operand or the operand does not fit a field; `out` is then unchanged.
[[nodiscard]] bool encode(const Instruction& instruction, std::vector<std::uint8_t>& out);
// With this row and no other: the inverse of decode.
[[nodiscard]] bool encode(const Encoding& row, const Operand& operand,
                          std::vector<std::uint8_t>& out);
// The instruction at the start of `code`; nothing if no row fits or it is cut off.
std::optional<Decoded> decode(std::span<const std::uint8_t> code);

// "U     E 0.0" in the given mnemonics. A jump shows its distance in words, a parameter of an FC
// its index.
std::string text(const Instruction& instruction, Mnemonics mnemonics);

}  // namespace merker::mc7
