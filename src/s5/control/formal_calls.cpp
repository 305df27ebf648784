#include "control/formal_calls.h"

#include "mc5/encoding.h"
#include "softplc/formal_operands.h"

namespace merker::cnc {
namespace {

using mc5::Decoded;
using mc5::OperandKind;
using mc5::Operation;
using translate5::Substitute;

// LW loads the word of the list as it is, LD two of them (S5-FB-17).
Substitute loaded(const Decoded& formal, std::uint32_t constant) {
  Substitute result{formal, {}};
  result.decoded.instruction.operation = Operation::LOAD;
  result.decoded.instruction.operand = {.kind = OperandKind::Constant, .value = constant};
  return result;
}

std::optional<Substitute> substitute(const Decoded& formal, std::span<const std::uint16_t> list,
                                     mc5::Variant variant) {
  const std::uint16_t first = list[0], second = list.size() > 1 ? list[1] : std::uint16_t{0};
  const Operation operation = formal.instruction.operation;
  if (operation == Operation::LOAD_WORD) return loaded(formal, first);
  if (operation == Operation::LOAD_DOUBLE)
    return loaded(formal, std::uint32_t{first} << 16 | second);
  if (operation == Operation::SUBSTITUTE) return std::nullopt;
  const auto actual = sinumerik::actualInstruction(formal.instruction, first);
  const mc5::Encoding* const row = actual ? sinumerik::rowOf(*actual) : nullptr;
  if (row == nullptr) return std::nullopt;
  return Substitute{{*actual, row, formal.words}, mc5::times(*formal.encoding, variant)};
}

}  // namespace

translate5::Substitutes substitutes(std::span<const std::uint16_t> code,
                                    std::span<const std::uint16_t> parameters,
                                    mc5::Variant variant) {
  translate5::Substitutes result;
  for (std::uint32_t at = 0; at < code.size(); ++at) {
    const auto decoded = mc5::decode(code.subspan(at));
    if (!decoded) continue;
    const mc5::Operand& operand = decoded->instruction.operand;
    const bool formal = operand.kind == OperandKind::Formal;
    if (!formal || operand.value == 0 || operand.value > parameters.size()) continue;
    if (auto found = substitute(*decoded, parameters.subspan(operand.value - 1), variant))
      result.emplace(at, *found);
  }
  return result;
}

}  // namespace merker::cnc
