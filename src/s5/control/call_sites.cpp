#include "control/call_sites.h"

#include <functional>

#include "mc5/encoding.h"
#include "mc5/range.h"

namespace merker::cnc {
namespace {

using mc5::BlockType;
using mc5::Operation;

struct Instruction {
  mc5::BlockId block;
  std::uint32_t words;
};

std::optional<Instruction> callAt(std::span<const std::uint16_t> code,
                                  const sinumerik::Environment& environment) {
  const auto decoded = mc5::decode(code);
  if (!decoded || decoded->words > code.size() || !mc5::inRange(decoded->instruction))
    return std::nullopt;
  const Operation operation = decoded->instruction.operation;
  const mc5::Operand& operand = decoded->instruction.operand;
  const bool calls = operation == Operation::CALL || operation == Operation::CALL_IF;
  if (!calls || operand.kind != mc5::OperandKind::Block) return std::nullopt;
  const mc5::BlockId block{operand.block, static_cast<std::uint16_t>(operand.value)};
  const bool macro = block.type == BlockType::Fb && environment.macros != nullptr &&
                     environment.macros->has(block.number);
  if (macro) return std::nullopt;
  return Instruction{block, decoded->words};
}

}  // namespace

void CallSites::clear() {
  calls_.clear();
  sites_.clear();
}

// Behind the call of an FB stands a jump over its parameter list (S5-FB-06).
translate5::Sites CallSites::add(const sinumerik::BlockMemory& blocks,
                                 const sinumerik::Entry& block,
                                 const sinumerik::Environment& environment) {
  translate5::Sites numbers;
  const auto words = std::span(blocks.program()).subspan(block.start, block.length);
  for (std::uint32_t at = 0; at < words.size(); ++at) {
    const auto call = callAt(words.subspan(at), environment);
    if (!call) continue;
    const sinumerik::Entry& called = blocks.find(call->block);
    if (!called.present) continue;
    numbers.emplace(at, static_cast<std::uint32_t>(calls_.size()));
    const std::uint32_t next = block.start + at + call->words;
    const bool list = call->block.type == BlockType::Fb;
    calls_.push_back({call->block, called.start, list ? next + 1 : 0, next});
    sites_.push_back({nullptr, at + call->words});
  }
  return numbers;
}

const Call* CallSites::find(const jit::Site* site) const {
  const bool inside =
      !std::less<>()(site, sites_.data()) && std::less<>()(site, sites_.data() + sites_.size());
  return inside ? &calls_[static_cast<std::size_t>(site - sites_.data())] : nullptr;
}

}  // namespace merker::cnc
