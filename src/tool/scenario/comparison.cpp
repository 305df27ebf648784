#include "scenario/comparison.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/bcd.h"
#include "base/text.h"
#include "check/relation.h"
#include "scenario/display.h"

namespace merker::simulator {
namespace {

using address::OperandKind;
using block::about;
using block::relates;
using block::Relation;

bool isTimerOrCounter(const Term& term) {
  return !term.constant && (term.reference.operand.kind == OperandKind::Timer ||
                            term.reference.operand.kind == OperandKind::Counter);
}

// "KT 500.1", not "S5T#50S".
bool isStep5(const Term& term) { return upper(term.text).starts_with("K"); }

unsigned widthOf(const Term& term) {
  return term.constant ? merker::bitWidth(term.constant->format)
                       : simulator::bitWidth(term.reference);
}

// How a timer or counter is looked at.
enum class View { Status, Coded, Number };

View view(OperandKind kind, const Term& other) {
  if (!other.constant) return View::Number;
  const Constant& constant = *other.constant;
  if (constant.format == ConstantFormat::Boolean) return View::Status;
  if (kind == OperandKind::Counter)
    return constant.format == ConstantFormat::Counter ? View::Coded : View::Number;
  if (constant.format == ConstantFormat::S5Time) return View::Coded;
  return constant.format == ConstantFormat::Integer && constant.bits <= 1 ? View::Status
                                                                          : View::Number;
}

std::optional<std::uint32_t> timerOrCounter(const Term& term, const Term& other,
                                            const Reader& read) {
  const View how = view(term.reference.operand.kind, other);
  address::Reference reference = term.reference;
  reference.operand.width = how == View::Status ? Width::Bit : Width::Word;
  const auto bits = read(reference);
  if (!bits || how != View::Number) return bits;
  return fromBcd(*bits & 0xFFF, 3);
}

TypeCode typeOf(const Term& term) { return term.constant ? TypeCode::Void : term.reference.type; }

bool isReal(const Term& term) { return typeOf(term) == TypeCode::Real; }

bool isSigned(const Term& term) {
  const TypeCode type = typeOf(term);
  return type == TypeCode::Int || type == TypeCode::DInt || type == TypeCode::Time;
}

float real(std::uint32_t bits) { return std::bit_cast<float>(bits); }

bool isOrder(Relation relation) {
  return relation != Relation::Equal && relation != Relation::NotEqual;
}

std::int32_t withSign(const Term& term, std::uint32_t bits) {
  const bool word = term.constant ? term.constant->format == ConstantFormat::Integer
                                  : bitWidth(term.reference) == 16;
  return word ? static_cast<std::int16_t>(bits) : static_cast<std::int32_t>(bits);
}

// 5, -7, L#40000 beside an operand that has no type of its own.
std::optional<std::int64_t> plainNumber(const Term& term, const Term& other) {
  if (!term.constant || other.constant || isTimerOrCounter(other) || isReal(other)) return {};
  const Constant& constant = *term.constant;
  if (constant.format == ConstantFormat::Integer) return static_cast<std::int16_t>(constant.bits);
  if (constant.format == ConstantFormat::LongInteger)
    return static_cast<std::int32_t>(constant.bits);
  return {};
}

// As a number beside `wanted`: with sign, but for what has no place in its width with sign (MW 0
// beside L#40000), bits, and bytes beside what is not negative.
std::int64_t besideNumber(const Term& term, std::uint32_t bits, std::int64_t wanted) {
  const unsigned width = bitWidth(term.reference);
  if (width == 1 || (width == 8 && wanted >= 0)) return bits;
  if (width < 32 && wanted >= std::int64_t{1} << (width - 1)) return bits;
  const std::uint32_t sign = 1u << (width - 1);
  return static_cast<std::int32_t>((bits ^ sign) - sign);
}

// A running timer may count with a longer base than the shortest that the constant has: S5T#2S is
// 16#0200 and 16#1020.
bool comparesTimes(const Term& left, const Term& right) {
  const auto isS5Time = [](const Term& term) {
    return term.constant && term.constant->format == ConstantFormat::S5Time;
  };
  return (isTimerOrCounter(left) && isS5Time(right)) || (isTimerOrCounter(right) && isS5Time(left));
}

std::uint32_t milliseconds(std::uint32_t coded) {
  return decodeS5Time(static_cast<std::uint16_t>(coded)).value_or(0);
}

// KT is one word of a timer, base included; S5T# is any word of that length.
bool isTimeWord(const Term& term) {
  return term.constant && term.constant->format == ConstantFormat::S5Time && isStep5(term);
}

bool related(const Term& left, std::uint32_t a, Relation relation, const Term& right,
             std::uint32_t b) {
  const bool word = isTimeWord(left) || isTimeWord(right);
  if (comparesTimes(left, right) && (!word || isOrder(relation)))
    return relates(milliseconds(a), relation, milliseconds(b));
  if (relation == Relation::About) return about(real(a), real(b));
  if (const auto number = plainNumber(right, left))
    return relates(besideNumber(left, a, *number), relation, *number);
  if (const auto number = plainNumber(left, right))
    return relates(*number, relation, besideNumber(right, b, *number));
  if (isOrder(relation) && (isReal(left) || isReal(right)))
    return relates(real(a), relation, real(b));
  if (isOrder(relation) && (isSigned(left) || isSigned(right)))
    return relates(withSign(left, a), relation, withSign(right, b));
  return relates(a, relation, b);
}

// As an INT where it fits, as formatConstant() writes it.
std::string showNumber(const Term& term, std::int64_t number) {
  const bool word = bitWidth(term.reference) < 32 && number >= INT16_MIN && number <= INT16_MAX;
  return formatConstant({word ? ConstantFormat::Integer : ConstantFormat::LongInteger,
                         static_cast<std::uint32_t>(number) & (word ? 0xFFFFu : ~0u)});
}

// In the notation of the constant that the operand is compared with, if that is wide enough for it.
std::string showLike(ConstantFormat format, const Term& term, std::uint32_t bits) {
  if (bitWidth(format) >= bitWidth(term.reference)) return formatConstant({format, bits});
  return formatOperand(term.reference, bits);
}

// KT and KZ have no counterpart in the notations of STEP 7.
std::optional<std::string> showStep5(ConstantFormat format, std::uint32_t bits) {
  if (format == ConstantFormat::S5Time) return formatTimeConstant(bits);
  if (format == ConstantFormat::Counter) return formatCountConstant(bits);
  return std::nullopt;
}

std::string show(const Term& term, const Term& other, std::uint32_t bits) {
  const Term& constant = term.constant ? term : other;
  if (constant.constant && isStep5(constant) && !isTimerOrCounter(term) && widthOf(term) <= 16)
    if (const auto text = showStep5(constant.constant->format, bits)) return *text;
  if (isTimerOrCounter(term) && view(term.reference.operand.kind, other) != View::Coded)
    return std::to_string(bits);
  if (!term.constant && bitWidth(term.reference) == 1) return std::to_string(bits);
  if (isTimerOrCounter(term)) return formatOperand(term.reference, bits);
  if (const auto number = plainNumber(other, term))
    return showNumber(term, besideNumber(term, bits, *number));
  if (term.constant) return formatConstant({term.constant->format, bits});
  return other.constant ? showLike(adapt(*other.constant, typeOf(term)).format, term, bits)
                        : formatOperand(term.reference, bits);
}

}  // namespace

std::optional<std::uint32_t> value(const Term& term, const Term& other, const Reader& read) {
  if (const auto number = plainNumber(term, other); number && bitWidth(other.reference) == 32)
    return static_cast<std::uint32_t>(*number);
  if (term.constant) return adapt(*term.constant, typeOf(other)).bits;
  return isTimerOrCounter(term) ? timerOrCounter(term, other, read) : read(term.reference);
}

bool holds(const Term& left, Relation relation, const Term& right, const Reader& read) {
  const auto a = value(left, right, read);
  const auto b = value(right, left, read);
  return a && b && related(left, *a, relation, right, *b);
}

std::string actualValue(const Term& left, const Term& right, const Reader& read) {
  const auto a = value(left, right, read);
  const auto b = value(right, left, read);
  if (!a || !b) return fmt::format("not there: {} does not exist", (a ? right : left).text);
  std::string text = show(left, right, *a);
  if (!right.constant) text += fmt::format(", {} is {}", right.text, show(right, left, *b));
  return text;
}

}  // namespace merker::simulator
