#include "scenario/axis_term.h"

#include <fmt/format.h>

#include <charconv>

#include "address/constant.h"
#include "base/text.h"
#include "check/relation.h"

namespace merker::simulator {
namespace {

constexpr std::string_view kPrefix = "axis.";

// 1000, L#1000, W#16#2000, TRUE: whole numbers, as the blocks show them.
std::optional<std::int64_t> wholeNumber(const std::string& text) {
  std::int64_t plain = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), plain);
  if (error == std::errc() && end == text.data() + text.size()) return plain;
  const auto constant = parseConstant(text, Position{});
  if (!constant) return std::nullopt;
  switch (constant.value().format) {
    case ConstantFormat::LongInteger:
      return static_cast<std::int32_t>(constant.value().bits);
    case ConstantFormat::Integer:
      return static_cast<std::int16_t>(constant.value().bits);
    case ConstantFormat::Boolean:
    case ConstantFormat::Byte:
    case ConstantFormat::Word:
    case ConstantFormat::DWord:
    case ConstantFormat::Binary:
    case ConstantFormat::LongBinary:
      return constant.value().bits;
    case ConstantFormat::Real:
    case ConstantFormat::Time:
    case ConstantFormat::S5Time:
    case ConstantFormat::Counter:
    case ConstantFormat::Characters:
    case ConstantFormat::LongCharacters:
    case ConstantFormat::Bytes:
    case ConstantFormat::LongBytes:
    case ConstantFormat::Date:
    case ConstantFormat::TimeOfDay:
    case ConstantFormat::Pointer:
      break;
  }
  return std::nullopt;
}

}  // namespace

bool namesAxis(std::string_view text) {
  return equalsIgnoreCase(text.substr(0, kPrefix.size()), kPrefix);
}

bool parseAxis(std::string_view name, std::string_view value, AxisTerm& result,
               const PositionOf& at, Problems& problems) {
  result.text = name;
  result.position = at(name);
  result.value = value;
  result.valuePosition = at(value.empty() ? name : value);
  const std::string_view wanted = name.substr(kPrefix.size());
  result.what = positioning::findAxisValue(wanted);
  if (result.what != nullptr) return true;
  problems.add(ProblemCode::P0762, result.position, "the axis", wanted,
               positioning::axisValueNames());
  return false;
}

void resolve(AxisTerm& term, const io::Configuration* hardware, Problems& problems) {
  if (hardware == nullptr) {
    problems.add(ProblemCode::P0983, term.position);
    return;
  }
  if (hardware->axis() == nullptr) {
    problems.add(ProblemCode::P0984, term.position, hardware->model->name,
                 "axis: drive = \"analog\" or \"digital\" in slot 2.5 configures one");
    return;
  }
  if (term.value.empty()) return;
  const auto number = wholeNumber(term.value);
  if (!number)
    problems.add(ProblemCode::P0989, term.valuePosition, term.value, term.text,
                 term.what->binary ? "it is 0 or 1" : "it is a whole number: 1000");
  term.number = number.value_or(0);
}

const positioning::Channel& axisOf(const controller::Controller& plc) {
  return *controller::capability<positioning::AxisOwner>(plc)->axis();
}

bool holds(const AxisTerm& term, block::Relation relation, const positioning::Channel& axis) {
  using block::Relation;
  const std::int64_t is = positioning::read(*term.what, axis);
  if (relation == Relation::Equal || relation == Relation::About) return is == term.number;
  if (relation == Relation::NotEqual) return is != term.number;
  return block::relates(static_cast<double>(is), relation, static_cast<double>(term.number));
}

std::string actualValue(const AxisTerm& term, const positioning::Channel& axis) {
  const std::int64_t is = positioning::read(*term.what, axis);
  return term.what->name == "errors" ? fmt::format("W#16#{:04X}", is) : fmt::format("{}", is);
}

}  // namespace merker::simulator
