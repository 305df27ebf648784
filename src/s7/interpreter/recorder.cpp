#include "interpreter/recorder.h"

#include <fmt/format.h>

#include <bit>
#include <optional>

#include "check/relation.h"
#include "interpreter/check_value.h"

namespace merker::interpreter {
namespace {

using block::CheckValue;
using block::Relation;

double realOf(std::uint32_t bits) { return double{std::bit_cast<float>(bits)}; }

// In the width of the expectation, if it fits.
std::string shown(std::uint32_t value, const block::CheckTerm& term) {
  if (term.relation == Relation::About) return fmt::format("{:e}", std::bit_cast<float>(value));
  const unsigned width = std::min(widthOf(term.left), widthOf(term.right));
  if (width <= 1 && value <= 1) return fmt::format("{}", value);
  if (width <= 8 && value <= 0xFF) return fmt::format("B#16#{:02X}", value);
  if (width <= 16 && value <= 0xFFFF) return fmt::format("W#16#{:04X}", value);
  return fmt::format("DW#16#{:08X}", value);
}

}  // namespace

std::uint32_t Recorder::add(const block::Check& check, const Translator& translator) {
  auto& terms = terms_.emplace_back();
  for (const block::CheckTerm& term : check.terms) {
    Term& snippets = terms.emplace_back();
    translator.translate(term.left.code, snippets.left);
    translator.translate(term.right.code, snippets.right);
  }
  records_.push_back({.check = &check, .onward = {}, .away = {}});
  return static_cast<std::uint32_t>(records_.size() - 1);
}

void Recorder::clear() {
  records_.clear();
  terms_.clear();
}

void Recorder::evaluate(cpu::Machine& m, std::uint32_t first, std::uint32_t count, bool away) {
  for (std::uint32_t i = first; i < first + count; ++i) evaluateOne(m, i, away);
}

void Recorder::evaluateOne(cpu::Machine& m, std::uint32_t number, bool away) {
  CheckRecord& record = records_[number];
  CheckSight& sight = away ? record.away : record.onward;
  ++sight.reached;
  for (std::size_t i = 0; i < record.check->terms.size(); ++i) {
    const block::CheckTerm& term = record.check->terms[i];
    const auto left = valueOf(m, term.left, terms_[number][i].left);
    const auto right = valueOf(m, term.right, terms_[number][i].right);
    if (left && right && block::holds(*left, term.relation, *right, realOf)) continue;
    if (sight.failures.size() >= kFailuresKept) continue;
    const std::string seen =
        left && right ? "is " + shown(*left, term) : "the operand cannot be read here";
    sight.failures.push_back({m.clock, term.text + ": " + seen});
  }
}

}  // namespace merker::interpreter
