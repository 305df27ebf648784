#include "graph7/operand_spelling.h"

#include <fmt/format.h>

#include "base/text.h"
#include "mc7/operand_text.h"

namespace merker::graph7 {
namespace {

// Constants and what is reached through others stay as they are typed.
std::string absolute(const step7::Access& access, std::string_view typed, Mnemonics mnemonics) {
  const mc7::OperandKind kind = access.operand.kind;
  const bool spells = kind == mc7::OperandKind::Memory || kind == mc7::OperandKind::Timer ||
                      kind == mc7::OperandKind::Counter || kind == mc7::OperandKind::Block;
  if (!spells || access.type != nullptr) return std::string(typed);
  const auto operation = access.peripheralOutput ? mc7::Operation::TRANSFER : mc7::Operation::LOAD;
  const std::string text = mc7::operandText({operation, access.operand}, mnemonics);
  return access.openDb < 0 ? text : fmt::format("DB{}.{}", access.openDb, text);
}

// A symbol without its quotation marks is read, too.
bool isAddress(const step7::Access& access, std::string_view typed) {
  const auto is = [&](Mnemonics mnemonics) {
    return normalized(absolute(access, typed, mnemonics)) == normalized(typed);
  };
  return access.variable == nullptr && (is(Mnemonics::German) || is(Mnemonics::International));
}

std::string one(std::string_view typed, const SourceOperands& operands) {
  if (typed.empty() || typed.find_first_of("#\"'?[") != typed.npos) return std::string(typed);
  const auto access = operands.alone(typed);
  if (access && isAddress(*access, typed))
    return absolute(*access, typed, operands.scope().mnemonics);
  std::string local = fmt::format("#{}", typed), symbol = fmt::format("\"{}\"", typed);
  if (const auto own = operands.alone(local); own && own->variable != nullptr) return local;
  if (operands.alone(symbol)) return symbol;
  return std::string(typed);
}

}  // namespace

std::string spelled(std::string_view typed, const SourceOperands& operands) {
  const std::size_t comma = typed.find(',');
  if (comma == typed.npos || typed.find_first_of("('") != typed.npos)
    return one(trim(typed), operands);
  const std::string_view block = trim(typed.substr(0, comma)),
                         instance = trim(typed.substr(comma + 1));
  const std::string first = one(block, operands), second = one(instance, operands);
  return first == block && second == instance ? std::string(typed)
                                              : fmt::format("{}, {}", first, second);
}

}  // namespace merker::graph7
