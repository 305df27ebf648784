#include "scenario/term.h"

#include <bit>
#include <cctype>

#include "base/text.h"
#include "scenario/long_number.h"
#include "scenario/long_value.h"

namespace merker::simulator {
namespace {

// Whether a text that is no valid constant was meant to be one: its own problem is then the better
// one.
bool looksLikeConstant(std::string_view text) {
  if (text.empty()) return false;
  const char first = text.front();
  // -MOTOR is a symbol of STEP 5.
  if (first == '-' && text.size() > 1 && std::isalpha(static_cast<unsigned char>(text[1])) != 0)
    return false;
  if ((first >= '0' && first <= '9') || first == '-' || first == '+' || first == '\'') return true;
  return first != '"' && first != '#' && text.substr(0, text.find('"')).find('#') < text.size();
}

std::optional<Problem> resolveBeside(Term& term, const address::Reference& partner,
                                     const Resolver& resolver) {
  const bool constant = parseConstant(term.text, term.position) ||
                        (resolver.constants && resolver.constants(term.text));
  if (!looksLikeConstant(term.text) && !constant) {
    if (auto problem = resolveOperand(term, resolver)) return problem;
    if (isLong(term.reference) && term.reference.type == partner.type) return std::nullopt;
    return otherNotation(partner, term.position);
  }
  auto content = parseLong(term.text, partner, term.position);
  if (!content) return content.error();
  term.content = std::move(content.value());
  return std::nullopt;
}

}  // namespace

std::optional<Problem> resolveOperand(Term& term, const Resolver& resolver) {
  auto reference = resolver(term.text, term.position);
  if (!reference) return reference.error();
  term.reference = std::move(reference.value());
  term.reference.text = term.text;
  return std::nullopt;
}

std::optional<Problem> resolveTerm(Term& term, const Resolver& resolver) {
  if (resolver.constants && (term.constant = resolver.constants(term.text))) return std::nullopt;
  auto constant = parseConstant(term.text, term.position);
  if (constant) {
    term.constant = constant.value();
    return std::nullopt;
  }
  auto beyond = resolver.constants ? beyondDoubleWord(term.text, term.position) : std::nullopt;
  if (beyond) return beyond;
  if (looksLikeConstant(term.text)) return constant.error();
  return resolveOperand(term, resolver);
}

void resolvePair(Term& left, Term& right, const Resolver& resolver, Problems& problems) {
  Term& first = looksLikeConstant(left.text) ? right : left;
  Term& second = &first == &left ? right : left;
  const auto problem = resolveTerm(first, resolver);
  // Without the one the notation of the other is open.
  if (problem && looksLikeConstant(second.text)) return problems.add(*problem);
  const auto other = isLong(first.reference) ? resolveBeside(second, first.reference, resolver)
                                             : resolveTerm(second, resolver);
  if (problem) problems.add(*problem);
  if (other)
    problems.add(*other);
  else if (!problem && isLong(second.reference) && !isLong(first))
    problems.add(otherNotation(second.reference, first.position));
}

unsigned bitWidth(const address::Reference& reference) {
  if (reference.operand.kind != address::OperandKind::Memory) return 16;
  if (reference.operand.width == Width::Bit) return 1;
  return 8 * byteCount(reference.operand.width);
}

Constant adapt(const Constant& constant, TypeCode type) {
  if (constant.format != ConstantFormat::Integer && constant.format != ConstantFormat::LongInteger)
    return constant;
  const auto number = constant.format == ConstantFormat::Integer
                          ? static_cast<std::int32_t>(static_cast<std::int16_t>(constant.bits))
                          : static_cast<std::int32_t>(constant.bits);
  if (type == TypeCode::DInt || type == TypeCode::Time)
    return {ConstantFormat::LongInteger, static_cast<std::uint32_t>(number)};
  if (type == TypeCode::Real)
    return {ConstantFormat::Real, std::bit_cast<std::uint32_t>(static_cast<float>(number))};
  return constant;
}

}  // namespace merker::simulator
