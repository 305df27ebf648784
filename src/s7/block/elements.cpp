#include "block/elements.h"

#include <fmt/ranges.h>

namespace merker::block {
namespace {

struct Walk {
  const ElementVisitor& visit;

  bool members(const std::vector<Variable>& list, const std::string& path, BitAddress base) const {
    for (const Variable& v : list)
      if (v.section != Section::Temp && !member(v, path + v.name, base + v.address)) return false;
    return true;
  }

  bool member(const Variable& v, const std::string& path, BitAddress at) const {
    static const TypePtr pointer = elementaryType(TypeCode::Pointer);
    return value(isStoredAsPointer(v) ? *pointer : *v.type, path, at, v);
  }

  bool value(const Type& type, const std::string& path, BitAddress at, const Variable& name) const {
    if (type.code == TypeCode::Array) return array(type, path, at, name);
    if (!type.members.empty()) return members(type.members, path + ".", at);
    return visit({path, type, at, name});
  }

  bool array(const Type& type, const std::string& path, BitAddress at, const Variable& name) const {
    std::vector<std::int32_t> index;
    for (const Dimension& d : type.dimensions) index.push_back(d.low);
    for (const BitAddress offset : elementOffsets(type)) {
      if (!value(*type.element, fmt::format("{}[{}]", path, fmt::join(index, ",")), at + offset,
                 name))
        return false;
      next(type, index);
    }
    return true;
  }

  // The last index runs fastest.
  static void next(const Type& type, std::vector<std::int32_t>& index) {
    for (std::size_t d = index.size(); d-- > 0;) {
      if (++index[d] <= type.dimensions[d].high) return;
      index[d] = type.dimensions[d].low;
    }
  }
};

}  // namespace

bool forEachElement(const std::vector<Variable>& variables, const ElementVisitor& visit) {
  return Walk{visit}.members(variables, "", 0);
}

}  // namespace merker::block
