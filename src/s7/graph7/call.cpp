#include "graph7/call.h"

#include <charconv>

#include "awl/call_text.h"
#include "base/text.h"

namespace merker::graph7 {
namespace {

// "L 20.0": the bit address of a local bit.
std::int64_t localBit(std::string_view text) {
  if (!text.starts_with("L ")) return -1;
  text = trim(text.substr(2));
  std::uint32_t byte = 0, bit = 0;
  const char* end = text.data() + text.size();
  const auto dot = std::from_chars(text.data(), end, byte);
  if (dot.ec != std::errc{} || dot.ptr == end || *dot.ptr != '.') return -1;
  const auto last = std::from_chars(dot.ptr + 1, end, bit);
  return last.ec == std::errc{} && last.ptr == end ? std::int64_t{bitAddress(byte, bit)} : -1;
}

bool isOutput(const block::Block* callee, std::string_view name) {
  if (callee == nullptr) return false;
  for (const block::Variable& v : callee->variables)
    if (v.name == name)
      return v.section == block::Section::Output || v.section == block::Section::Return;
  return false;
}

// "IN := M 0.0,"
graph::Argument argument(std::string_view line, const block::Block* callee) {
  const std::size_t at = line.find(" := ");
  graph::Argument out;
  out.name = trim(line.substr(0, at));
  std::string_view actual = at == std::string_view::npos ? "" : line.substr(at + 4);
  if (actual.ends_with(',') || actual.ends_with(')')) actual.remove_suffix(1);
  out.text = actual;
  out.wire = localBit(actual);
  out.output = isOutput(callee, out.name);
  return out;
}

const mc7::Operand* calledBlock(const mc7::Listing& listing, std::size_t at, std::size_t count) {
  for (std::size_t i = at; i < at + count; ++i) {
    const mc7::Place& place = listing.places[i];
    if (place.known && place.instruction.operation == mc7::Operation::UC &&
        place.instruction.operand.kind == mc7::OperandKind::Block)
      return &place.instruction.operand;
  }
  return nullptr;
}

}  // namespace

void describeCall(const mc7::Listing& listing, std::size_t at, std::size_t count,
                  const awl::Names& names, const awl::Blocks& blocks, Mnemonics mnemonics,
                  graph::Statement& statement) {
  const mc7::Operand* called = calledBlock(listing, at, count);
  const BlockId id = called == nullptr
                         ? BlockId{}
                         : BlockId{called->blockKind, static_cast<std::uint16_t>(called->value)};
  statement.operand.text = called == nullptr ? "?" : toString(id);
  const auto lines = awl::callText(listing, at, count, names, blocks, mnemonics);
  if (lines.empty()) return;
  std::string_view head = lines.front();  // "CALL  FB 1, DB 1 ("
  head.remove_prefix(head.find(' '));
  if (head.ends_with('(')) head.remove_suffix(1);
  statement.operand.text = trim(head);
  const block::Block* callee = called == nullptr ? nullptr : blocks(id);
  for (std::size_t i = 1; i < lines.size(); ++i)
    statement.arguments.push_back(argument(lines[i], callee));
}

}  // namespace merker::graph7
