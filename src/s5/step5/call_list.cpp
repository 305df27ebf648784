#include "step5/call_list.h"

#include <fmt/format.h>

#include "mc5/constant.h"
#include "mc5/operand_text.h"
#include "mc5/parameter_list.h"
#include "mc5/resident_blocks.h"
#include "step5/declaration.h"

namespace merker::step5 {
namespace {

using mc5::Block;
using mc5::BlockType;
using mc5::OperandKind;
using mc5::Parameter;

mc5::Operand actualOperand(const Parameter& parameter, std::span<const std::uint16_t> words) {
  const auto decoded = mc5::decode(words.first(1));
  const bool data = parameter.kind == mc5::ParameterKind::Data;
  return data || !decoded ? mc5::Operand{} : decoded->instruction.operand;
}

std::string actualText(const Parameter& parameter, std::span<const std::uint16_t> words) {
  if (parameter.kind == mc5::ParameterKind::Data) {
    std::uint32_t value = words[0];
    if (parameter.format == mc5::Format::Float) value = value << 16 | words[1];
    return mc5::constantText(
        {.kind = OperandKind::Constant, .format = parameter.format, .value = value});
  }
  const auto decoded = mc5::decode(words.first(1));
  return decoded ? mc5::operandText(decoded->instruction.operand)
                 : fmt::format("KH {:04X}", words[0]);
}

const Block* functionBlock(const mc5::Program& program, std::uint32_t number) {
  const auto id = static_cast<std::uint16_t>(number);
  const auto found = program.find({BlockType::Fb, id});
  return found != program.end() ? &found->second : mc5::findResident(id);
}

}  // namespace

std::optional<CallList> callList(const mc5::Program& program, const Block& block,
                                 const mc5::Instruction& call, std::uint32_t next) {
  if (!mc5::callsFunctionBlock(call)) return std::nullopt;
  const Block* const fb = functionBlock(program, call.operand.value);
  const auto end = mc5::endOfList(block.words, next);
  if (fb == nullptr || !end) return std::nullopt;
  CallList list{fb, *end, {}};
  std::uint32_t at = next + 1;
  for (const Parameter& parameter : fb->parameters) {
    const std::uint32_t words = wordCount(parameter);
    if (at + words > *end) return std::nullopt;
    const auto code = std::span<const std::uint16_t>(block.words).subspan(at, words);
    list.parameters.push_back(
        {at, words, parameter.name, actualText(parameter, code), actualOperand(parameter, code)});
    at += words;
  }
  return at == *end ? std::optional(std::move(list)) : std::nullopt;
}

}  // namespace merker::step5
