// What a value of the protocol looks like, as protocol.def writes it: "path: string,
// lines: 1..99[]".
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/json.h"

namespace merker::workbench {

struct Shape {
  enum class Kind : std::uint8_t {
    Text,
    Number,  // from `low` to `high`
    Whole,   // likewise
    Flag,
    Null,
    Any,
    Word,    // the text `word`
    List,    // of parts[0]
    Tuple,   // the parts, one after the other
    Map,     // names of any kind, with values as parts[0]
    Either,  // one of the parts
    Object   // the parts are its fields
  };
  Kind kind = Kind::Any;
  std::string word{};
  double low = 0, high = 0;
  std::vector<Shape> parts{};

  // As the field of an object.
  std::string name{};
  bool optional = false;

  const Shape* field(std::string_view wanted) const;
};

using Shapes = std::map<std::string, Shape, std::less<>>;

// An object with these fields; `known` has the types with a name. The texts are ours: one that
// cannot be read is a mistake of the table (std::logic_error).
Shape fieldsShape(std::string_view text, const Shapes& known);

// P1316 for the first field of `value`, however deep, that the shape does not have; those `besides`
// are good at its top.
std::optional<Problem> unknownField(const Shape& shape, const Json& value,
                                    const std::string& path = {},
                                    std::span<const std::string_view> besides = {});

}  // namespace merker::workbench
