// A parameter of a system function by its name, looked up in the function's row while Merker is
// compiled: a name that the row does not have does not compile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "address/block_id.h"
#include "system/function.h"

namespace merker::system {

// The text up to `end`, taken off.
constexpr std::string_view take(std::string_view& text, std::string_view end) {
  const std::size_t at = text.find(end);
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + end.size());
  return part;
}

struct ParameterText {
  BlockKind kind;
  std::uint16_t number;
  std::string_view parameters;  // "in NR BYTE; out CV INT; return RET_VAL INT"
};

inline constexpr ParameterText kParameterTexts[] = {
#define FUNCTION(kind, number, name, function, requirement, parameters) \
  {BlockKind::kind, number, parameters},
#define CP_FUNCTION(kind, number, name, function, requirement, parameters) \
  {BlockKind::kind, kCpRow + number, parameters},
#define CODE(kind, number, code, text)
#define CODES(kind, number, group)
#define GROUP_CODE(group, code, text)
#include "system/cp_library.inc"
#include "system/functions.inc"
#include "system/library.inc"
#undef FUNCTION
#undef CP_FUNCTION
#undef CODE
#undef CODES
#undef GROUP_CODE
};

constexpr std::string_view parametersInRow(BlockKind kind, std::uint16_t number) {
  for (const ParameterText& row : kParameterTexts)
    if (row.kind == kind && row.number == number) return row.parameters;
  throw "no row of the tables has this number";
}

constexpr std::size_t indexInRow(std::string_view parameters, std::string_view name) {
  for (std::size_t i = 0; !parameters.empty(); ++i) {
    std::string_view one = take(parameters, "; ");
    take(one, " ");  // in, out, inout, return, stat
    if (take(one, " ") == name) return i;
  }
  throw "the row has no parameter of this name";
}

// Made of a string literal; `index` is the place of the parameter in its row, from 0.
template <BlockKind kind, std::uint16_t number>
struct ParameterName {
  static constexpr std::string_view kParameters = parametersInRow(kind, number);
  std::size_t index;
  consteval ParameterName(const char* name) : index(indexInRow(kParameters, name)) {}
};

}  // namespace merker::system
