#include "cnc/block_links.h"

#include "mc5/encoding.h"
#include "mc5/range.h"

namespace merker::cnc {
namespace {

using mc5::BlockType;
using mc5::Operation;
using sinumerik::Displays;
using sinumerik::Machine;

bool isLink(Operation o) {
  switch (o) {
    case Operation::CALL:
    case Operation::CALL_IF:
    case Operation::END:
    case Operation::END_IF:
    case Operation::END_ALWAYS:
    case Operation::OPEN:
      return true;
    default:
      return false;
  }
}

void clearChain(Displays& d) { d.os = d.orBit = d.chain = false; }  // OP-24

// Behind the call of an FB stands a jump over its parameter list (S5-FB-06).
bool call(const Link& link, Machine& m, Displays& displays) {
  auto& frames = m.level().frames;
  const sinumerik::Entry& entry = m.blocks.find(link.block);
  if (!entry.present || frames.size() >= sinumerik::kNesting) return false;
  const std::uint32_t next = frames.back().next += link.words;
  frames.push_back({.block = link.block,
                    .start = entry.start,
                    .next = entry.start,
                    .parameters = link.block.type == BlockType::Fb ? next + 1 : 0,
                    .data = frames.back().data});
  clearChain(displays);
  return true;
}

// With the block of the OB the level ends: there the operating system looks at times.
bool end(Machine& m, Displays& displays) {
  auto& frames = m.level().frames;
  if (frames.size() == 1) return false;
  frames.pop_back();
  clearChain(displays);
  return true;
}

bool open(const Link& link, Machine& m) {
  const sinumerik::Entry& entry = m.blocks.find(link.block);
  if (!entry.present) return false;
  sinumerik::Frame& frame = m.frame();
  frame.next += link.words;
  frame.data = {true, link.block.number, entry.start, entry.length};
  return true;
}

}  // namespace

std::optional<Link> linkAt(std::span<const std::uint16_t> code,
                           const sinumerik::Environment& environment) {
  const auto decoded = mc5::decode(code);
  if (!decoded || !isLink(decoded->instruction.operation) || !mc5::inRange(decoded->instruction))
    return std::nullopt;
  const mc5::Operand& operand = decoded->instruction.operand;
  const mc5::BlockId block{operand.block, static_cast<std::uint16_t>(operand.value)};
  const bool names = operand.kind == mc5::OperandKind::Block;
  if (names && block.type == BlockType::Fb && environment.macros != nullptr &&
      environment.macros->has(block.number))
    return std::nullopt;
  return Link{decoded->instruction.operation, block, static_cast<std::uint8_t>(decoded->words),
              mc5::times(*decoded->encoding, environment.variant).longest};
}

bool follow(const Link& link, Machine& m, Displays& displays) {
  switch (link.operation) {
    case Operation::CALL_IF:
      return displays.vke && call(link, m, displays);
    case Operation::CALL:
      return call(link, m, displays);
    case Operation::OPEN:
      return open(link, m);
    case Operation::END_IF:
      return displays.vke && end(m, displays);
    default:
      return end(m, displays);
  }
}

}  // namespace merker::cnc
