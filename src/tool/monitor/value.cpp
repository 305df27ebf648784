#include "monitor/value.h"

#include "base/bcd.h"
#include "base/text.h"
#include "monitor/nowhere.h"
#include "plc/cell_value.h"
#include "scenario/long_number.h"
#include "scenario/long_value.h"
#include "scenario/term.h"

namespace merker::monitor {
namespace {

using simulator::isLong;

// T and Z as bits show their status.
bool isStatus(const address::Reference& reference, DisplayFormat format) {
  return format == DisplayFormat::Bool && reference.operand.kind != address::OperandKind::Memory;
}

Result<Value> parseContent(const address::Reference& reference, std::string_view text) {
  auto content = simulator::parseLong(trim(text), reference, nowhere());
  if (!content) return content.error();
  constexpr std::uint32_t kHeader = 2;  // S7-TYPES-19
  const std::uint32_t longest = reference.bytes - kHeader;
  if (reference.type == TypeCode::String && content->size() > longest)
    return makeProblem(ProblemCode::P0961, nowhere(), std::string(text), content->size(),
                       reference.text, longest);
  return Value{0, std::move(content.value())};
}

// A whole number is the count of a counter; of a timer it lacks the base.
Result<Value> parseCell(const address::Reference& reference, const Constant& constant,
                        std::string_view text) {
  const bool number =
      constant.format == ConstantFormat::Integer || constant.format == ConstantFormat::LongInteger;
  if (!number) return Value{constant.bits, {}};
  const bool counter = address::isCounter(reference.operand);
  if (counter && constant.bits <= 999) return Value{toBcd(constant.bits, 3), {}};
  return makeProblem(ProblemCode::P1210, nowhere(), std::string(trim(text)),
                     name(counter ? DisplayFormat::Counter : DisplayFormat::S5Time));
}

}  // namespace

std::optional<Value> read(const controller::Controller& plc, const address::Reference& reference) {
  if (!isLong(reference)) {
    const auto bits = plc.read(reference);
    return bits ? std::optional(Value{*bits, {}}) : std::nullopt;
  }
  auto content = simulator::readLong(reference, plc);
  return content ? std::optional(Value{0, std::move(*content)}) : std::nullopt;
}

bool write(controller::Controller& plc, const address::Reference& reference, const Value& value) {
  if (isLong(reference)) return simulator::writeLong(reference, value.content, plc);
  return plc.write(reference, value.bits);
}

std::optional<Problem> checkFormat(const address::Reference& reference, DisplayFormat format) {
  const bool good = isLong(reference) ? format == DisplayFormat::Automatic
                                      : fits(format, simulator::bitWidth(reference)) ||
                                            isStatus(reference, format);
  if (good) return std::nullopt;
  return makeProblem(ProblemCode::P1209, nowhere(), reference.text, name(format), bitsText(format));
}

std::string show(const address::Reference& reference, const Value& value, DisplayFormat format) {
  if (isLong(reference)) return simulator::formatLong(reference.type, value.content);
  return show(reference, value.bits, format);
}

Result<Value> parse(const address::Reference& reference, std::string_view text,
                    DisplayFormat format) {
  if (isLong(reference) || format == DisplayFormat::Kg)
    if (auto problem = checkFormat(reference, format)) return *problem;
  if (isLong(reference)) return parseContent(reference, text);
  const auto bits = parseValue(reference, text, format);
  if (!bits) return bits.error();
  return Value{*bits, {}};
}

Result<Value> parse(const address::Reference& reference, std::string_view text,
                    DisplayFormat format, const simulator::Resolver::Constants& constants) {
  const bool plain = constants && !isLong(reference) && format != DisplayFormat::Kg;
  const auto constant = plain ? constants(trim(text)) : std::nullopt;
  if (plain && !constant)
    if (auto problem = simulator::beyondDoubleWord(trim(text), nowhere())) return *problem;
  if (!constant) return parse(reference, text, format);
  if (controller::isCell(reference)) return parseCell(reference, *constant, text);
  const unsigned width = simulator::bitWidth(reference);
  if (width < 32 && constant->bits >> width != 0)
    return makeProblem(ProblemCode::P0955, nowhere(), std::string(text), reference.text, width);
  return Value{constant->bits, {}};
}

}  // namespace merker::monitor
