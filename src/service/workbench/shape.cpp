#include "workbench/shape.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <stdexcept>

namespace merker::workbench {
namespace {

using Form = Shape::Kind;

constexpr double kLowest = std::numeric_limits<double>::lowest();
constexpr double kHighest = std::numeric_limits<double>::max();

// A mistake in the table, which protocol_test finds.
[[noreturn]] void wrong(std::string_view text) {
  throw std::logic_error(fmt::format("protocol.def: '{}'", text));
}

class ShapeReader {
 public:
  ShapeReader(std::string_view text, const Shapes& known) : rest_(text), known_(known) { blanks(); }

  Shape fields(std::string_view end);
  bool atEnd() const { return rest_.empty(); }

 private:
  Shape type();
  Shape single();
  Shape primary();
  Shape tuple();
  Shape range();
  Shape named(const std::string& word);

  void blanks() { rest_.remove_prefix(std::min(rest_.size(), rest_.find_first_not_of(' '))); }
  bool take(std::string_view word);
  void need(std::string_view word);
  std::string run(auto&& belongs);
  std::string quoted();

  std::string_view rest_;
  const Shapes& known_;
};

bool ShapeReader::take(std::string_view word) {
  if (!rest_.starts_with(word)) return false;
  rest_.remove_prefix(word.size());
  blanks();
  return true;
}

void ShapeReader::need(std::string_view word) {
  if (!take(word)) wrong(rest_);
}

std::string ShapeReader::run(auto&& belongs) {
  const auto end = std::ranges::find_if_not(rest_, belongs);
  const std::string word(rest_.begin(), end);
  rest_.remove_prefix(word.size());
  return word;
}

std::string ShapeReader::quoted() {
  need("'");
  std::string word = run([](char c) { return c != '\''; });
  need("'");
  return word;
}

// "path: string, replace: boolean = false": what has a value can be missing.
Shape ShapeReader::fields(std::string_view end) {
  Shape object{.kind = Form::Object};
  while (end.empty() ? !atEnd() : !take(end)) {
    if (!object.parts.empty()) need(",");
    const std::string name = run([](unsigned char c) { return std::isalnum(c) != 0; });
    const bool optional = take("?");
    need(":");
    Shape shape = type();
    shape.name = name;
    shape.optional = optional;
    if (take("=")) {
      shape.optional = true;
      rest_.starts_with('\'') ? void(quoted()) : void(run([](char c) { return c != ','; }));
    }
    object.parts.push_back(std::move(shape));
  }
  return object;
}

Shape ShapeReader::type() {
  Shape first = single();
  if (!take("|")) return first;
  Shape either{.kind = Form::Either, .parts = {std::move(first)}};
  do either.parts.push_back(single());
  while (take("|"));
  return either;
}

Shape ShapeReader::single() {
  Shape shape = primary();
  while (take("[]")) shape = Shape{.kind = Form::List, .parts = {std::move(shape)}};
  return shape;
}

Shape ShapeReader::primary() {
  if (rest_.starts_with('\'')) return Shape{.kind = Form::Word, .word = quoted()};
  if (take("{")) return fields("}");
  if (take("[")) return tuple();
  if (take("(")) {
    Shape inner = type();
    need(")");
    return inner;
  }
  if (!rest_.empty() && (rest_[0] == '-' || std::isdigit(static_cast<unsigned char>(rest_[0]))))
    return range();
  return named(run([](unsigned char c) { return std::isalnum(c) != 0; }));
}

Shape ShapeReader::tuple() {
  Shape list{.kind = Form::Tuple};
  do list.parts.push_back(type());
  while (take(","));
  need("]");
  return list;
}

// 0..255; of any numbers if the second has a point or an exponent: 0.1..100., -1e12..1e12.
Shape ShapeReader::range() {
  const std::string text =
      run([](char c) { return c == '-' || c == '.' || c == 'e' || (c >= '0' && c <= '9'); });
  blanks();
  const std::size_t between = text.find("..");
  if (between == std::string::npos) wrong(text);
  const std::string low = text.substr(0, between), high = text.substr(between + 2);
  return Shape{.kind = high.find_first_of(".e") == std::string::npos ? Form::Whole : Form::Number,
               .low = std::stod(low),
               .high = std::stod(high)};
}

Shape ShapeReader::named(const std::string& word) {
  blanks();
  if (word == "string") return {.kind = Form::Text};
  if (word == "number") return {.kind = Form::Number, .low = kLowest, .high = kHighest};
  if (word == "boolean") return {.kind = Form::Flag};
  if (word == "null") return {.kind = Form::Null};
  if (word == "any") return {.kind = Form::Any};
  if (word == "true") return {.kind = Form::Flag};
  if (word == "Map") {
    need("<");
    Shape map{.kind = Form::Map, .parts = {type()}};
    need(">");
    return map;
  }
  const auto found = known_.find(word);
  if (found == known_.end()) wrong(word);
  return found->second;
}

std::string namesOf(const Shape& object) {
  std::string names;
  for (const Shape& one : object.parts) names += (names.empty() ? "" : ", ") + one.name;
  return names;
}

}  // namespace

const Shape* Shape::field(std::string_view wanted) const {
  const auto found = std::ranges::find(parts, wanted, &Shape::name);
  return found == parts.end() ? nullptr : &*found;
}

Shape fieldsShape(std::string_view text, const Shapes& known) {
  return ShapeReader(text, known).fields("");
}

std::optional<Problem> unknownField(const Shape& shape, const Json& value, const std::string& path,
                                    std::span<const std::string_view> besides) {
  constexpr std::size_t kLongestName = 100;
  if (shape.kind == Form::List && value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      if (auto problem = unknownField(shape.parts[0], value[i], fmt::format("{}[{}]", path, i)))
        return problem;
  if (shape.kind != Form::Object || !value.is_object()) return std::nullopt;
  const std::string before = path.empty() ? "" : path + ".";
  for (const auto& [key, one] : value.items()) {
    if (std::ranges::find(besides, key) != besides.end()) continue;
    const Shape* field = shape.field(key);
    if (field == nullptr)
      return makeProblem(ProblemCode::P1316, nowhere(), "field",
                         before + key.substr(0, kLongestName),
                         shape.parts.empty() ? "" : "; valid: " + namesOf(shape));
    if (auto problem = unknownField(*field, one, before + key)) return problem;
  }
  return std::nullopt;
}

}  // namespace merker::workbench
