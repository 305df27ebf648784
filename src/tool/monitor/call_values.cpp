#include "monitor/call_values.h"

#include <algorithm>

#include "awl/call_text.h"
#include "base/text.h"
#include "monitor/nowhere.h"

namespace merker::monitor {
namespace {

const block::Variable* variable(const block::Block& block, std::string_view name) {
  const auto at = std::ranges::find_if(
      block.variables, [name](const block::Variable& one) { return one.name == name; });
  return at != block.variables.end() && at->type && isElementary(at->type->code) ? &*at : nullptr;
}

// Behind them STA is not the bit they are about.
bool hidesItsBit(mc7::Operation operation) {
  using enum mc7::Operation;
  return operation == SET_BIT || operation == RESET_BIT || operation == EDGE_POSITIVE ||
         operation == EDGE_NEGATIVE;
}

class CallReader {
 public:
  CallReader(const block::Block& block, awl::Blocks blocks, const simulator::Resolver& resolver)
      : block_(block),
        blocks_(std::move(blocks)),
        resolver_(resolver),
        names_(block),
        listing_(mc7::list(block.code)) {}

  std::vector<CallValues> all() const {
    std::vector<CallValues> calls;
    const std::size_t end = listing_.places.size();
    for (std::size_t at = 0; at < end;) {
      const std::size_t count = awl::callLength(listing_, at, end);
      CallValues call = count > 0 ? this->call(at, count) : ownBit(listing_.places[at]);
      if (!call.operands.empty()) calls.push_back(std::move(call));
      at += std::max<std::size_t>(count, 1);
    }
    return calls;
  }

 private:
  CallValues call(std::size_t at, std::size_t count) const {
    CallValues call{listing_.places[at].offset, listing_.places[at + count - 1].offset, {}};
    const block::Block* callee = this->callee(at, count);
    if (callee == nullptr) return call;
    const auto lines = awl::callText(listing_, at, count, names_, blocks_, Mnemonics::German);
    for (std::size_t i = 1; i < lines.size(); ++i)
      if (auto operand = this->operand(lines[i], *callee)) call.operands.push_back(*operand);
    call.values.resize(call.operands.size());
    return call;
  }

  CallValues ownBit(const mc7::Place& place) const {
    CallValues values{place.offset, place.offset, {}};
    if (!place.known || !hidesItsBit(place.instruction.operation)) return values;
    const std::string name = names_.of(place.instruction.operand);
    const block::Variable* bit = name.empty() ? nullptr : variable(block_, name.substr(1));
    if (bit == nullptr || bit->type->code != TypeCode::Bool) return values;
    values.operands.push_back({.parameter = bit->name,
                               .output = true,
                               .type = TypeCode::Bool,
                               .local = bit->name,
                               .reference = {}});
    values.values.resize(1);
    return values;
  }

  const block::Block* callee(std::size_t at, std::size_t count) const {
    for (std::size_t i = at; i < at + count; ++i) {
      const mc7::Instruction& one = listing_.places[i].instruction;
      if (listing_.places[i].known && one.operation == mc7::Operation::UC &&
          one.operand.kind == mc7::OperandKind::Block)
        return blocks_({one.operand.blockKind, static_cast<std::uint16_t>(one.operand.value)});
    }
    return nullptr;
  }

  // "IN := M 0.0,"
  std::optional<ActualOperand> operand(std::string_view line, const block::Block& callee) const {
    const std::size_t at = line.find(" := ");
    if (at == std::string_view::npos) return std::nullopt;
    std::string_view actual = line.substr(at + 4);
    if (actual.ends_with(',') || actual.ends_with(')')) actual.remove_suffix(1);
    const block::Variable* formal = variable(callee, trim(line.substr(0, at)));
    if (formal == nullptr) return std::nullopt;
    ActualOperand out{.parameter = formal->name,
                      .output = formal->section == block::Section::Output ||
                                formal->section == block::Section::Return,
                      .type = formal->type->code,
                      .local = {},
                      .reference = {}};
    if (actual.starts_with('#')) {
      out.local = actual.substr(1);
      return variable(block_, out.local) == nullptr ? std::nullopt : std::optional(out);
    }
    auto reference = resolver_(actual, nowhere());
    if (!reference) return std::nullopt;
    out.reference = std::move(*reference);
    return out;
  }

  const block::Block& block_;
  awl::Blocks blocks_;
  const simulator::Resolver& resolver_;
  awl::Names names_;
  mc7::Listing listing_;
};

}  // namespace

std::vector<CallValues> callsOf(const BlockCode& code, const block::Program& program,
                                const block::Program& library,
                                const simulator::Resolver& resolver) {
  if (code.s7() == nullptr) return {};
  const awl::Blocks blocks = [&](BlockId id) -> const block::Block* {
    for (const block::Program* one : {&program, &library})
      if (const auto at = one->find(id); at != one->end()) return &at->second;
    return nullptr;
  };
  return CallReader(*code.s7(), blocks, resolver).all();
}

}  // namespace merker::monitor
