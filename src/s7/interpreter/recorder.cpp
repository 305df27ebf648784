#include "interpreter/recorder.h"

#include <fmt/format.h>

#include <bit>
#include <optional>

#include "interpreter/check_value.h"

namespace merker::interpreter {
namespace {

using block::Relation;

double realOf(std::uint32_t bits) { return double{std::bit_cast<float>(bits)}; }

// In the width of the expectation, if it fits.
std::string shown(std::uint32_t value, const block::CheckTerm& term) {
  if (term.relation == Relation::About) return fmt::format("{:e}", std::bit_cast<float>(value));
  const unsigned width = std::min(term.left.width, term.right.width);
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
  records_.emplace_back(check);
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
  block::CheckRecord& record = records_[number];
  record.evaluate(m.clock, away, [&](std::size_t i) {
    const block::CheckTerm& term = record.check().terms[i];
    const Term& snippets = terms_[number][i];
    return block::judge(term, valueOf(m, term.left, snippets.left),
                        valueOf(m, term.right, snippets.right), realOf, shown);
  });
}

}  // namespace merker::interpreter
