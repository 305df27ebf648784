// What the readers of CALL sequences share.
#pragma once

#include <string>
#include <vector>

#include "mc7/listing.h"

namespace merker::awl {

using Body = std::vector<const mc7::Place*>;

inline bool isLocal(const mc7::Operand& o) {
  return o.kind == mc7::OperandKind::Memory && o.area == Area::Local;
}
// AUF DB n; `reg` 1: AUF DI n.
inline bool opensBlock(const mc7::Instruction& i, int reg) {
  return i.operation == mc7::Operation::OPEN && i.operand.kind == mc7::OperandKind::Block &&
         i.operand.blockKind == BlockKind::DB && i.operand.reg == reg;
}
inline bool opensDb(const mc7::Instruction& i) { return opensBlock(i, 0); }
inline bool loads(const mc7::Instruction& i) {
  return i.operation == mc7::Operation::LOAD || i.operation == mc7::Operation::AND;
}
inline bool stores(const mc7::Instruction& i) {
  return i.operation == mc7::Operation::TRANSFER || i.operation == mc7::Operation::ASSIGN;
}

// "T 5", "FB 3" for a parameter that takes a number; empty for other types.
std::string numberText(TypeCode type, std::uint32_t number, Mnemonics mnemonics);
// A constant in the notation of its type.
std::string constantText(TypeCode type, std::uint32_t bits);
// P#DB5.DBX 0.0, P#M 10.0; V is L of the caller.
std::string pointerOf(std::uint32_t db, std::uint32_t pointer, Mnemonics mnemonics);
// P#DB5.DBX 0.0 BYTE 10; empty if the head is none of an ANY.
std::string anyText(std::uint32_t head, std::uint32_t count, std::uint32_t db,
                    std::uint32_t pointer, Mnemonics mnemonics);

}  // namespace merker::awl
