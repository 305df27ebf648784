// Short ways to types, variables and blocks for the tests of this folder.
#pragma once

#include <utility>

#include "block/block.h"

namespace merker::block {

inline Variable var(TypePtr type, Section section = Section::Static,
                    std::vector<std::uint8_t> initial = {}) {
  Variable v;
  v.section = section;
  v.type = std::move(type);
  v.hasInitial = !initial.empty();
  v.initial = std::move(initial);
  return v;
}
inline Variable var(TypeCode code, Section section = Section::Static,
                    std::vector<std::uint8_t> initial = {}) {
  return var(elementaryType(code), section, std::move(initial));
}

inline TypePtr instanceOf(std::uint16_t number, std::vector<Variable> members) {
  Type type = *structType(std::move(members));
  type.code = TypeCode::FunctionBlock;
  type.length = number;
  return std::make_shared<const Type>(std::move(type));
}

}  // namespace merker::block
