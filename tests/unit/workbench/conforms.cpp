#include "conforms.h"

#include <algorithm>

namespace merker::workbench::test {
namespace {

using Form = Shape::Kind;

std::string objectMismatch(const Shape& shape, const Json& value, const std::string& place) {
  for (const Shape& field : shape.parts)
    if (!value.contains(field.name) && !field.optional) return place + "." + field.name + " lacks";
  for (const auto& [key, one] : value.items()) {
    const std::string at = place + "." + key;
    const Shape* field = shape.field(key);
    if (field == nullptr) return at + " is not in the table";
    if (const std::string wrong = mismatch(*field, one, at); !wrong.empty()) return wrong;
  }
  return {};
}

std::string listMismatch(const Shape& shape, const Json& value, const std::string& place) {
  const bool tuple = shape.kind == Form::Tuple;
  if (tuple && value.size() != shape.parts.size()) return place + " has another length";
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string wrong =
        mismatch(shape.parts[tuple ? i : 0], value[i], fmt::format("{}[{}]", place, i));
    if (!wrong.empty()) return wrong;
  }
  return {};
}

std::string mapMismatch(const Shape& shape, const Json& value, const std::string& place) {
  for (const auto& [key, one] : value.items())
    if (const std::string wrong = mismatch(shape.parts[0], one, place + "." + key); !wrong.empty())
      return wrong;
  return {};
}

bool simple(const Shape& shape, const Json& value) {
  switch (shape.kind) {
    case Form::Text:
      return value.is_string();
    case Form::Number:
    case Form::Whole:
      return value.is_number() && value >= shape.low && value <= shape.high;
    case Form::Flag:
      return value.is_boolean();
    case Form::Null:
      return value.is_null();
    case Form::Word:
      return value == shape.word;
    case Form::List:
    case Form::Tuple:
      return value.is_array();
    case Form::Map:
    case Form::Object:
      return value.is_object();
    case Form::Either:
      return std::ranges::any_of(
          shape.parts, [&](const Shape& one) { return mismatch(one, value, "").empty(); });
    case Form::Any:
      return true;
  }
  return false;
}

}  // namespace

std::string mismatch(const Shape& shape, const Json& value, const std::string& place) {
  if (!simple(shape, value)) return place + " is not so: " + value.dump().substr(0, 200);
  if (shape.kind == Form::Object) return objectMismatch(shape, value, place);
  if (shape.kind == Form::Map) return mapMismatch(shape, value, place);
  if (shape.kind == Form::List || shape.kind == Form::Tuple)
    return listMismatch(shape, value, place);
  return {};
}

}  // namespace merker::workbench::test
