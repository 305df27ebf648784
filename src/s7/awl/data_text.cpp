#include "awl/data_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "awl/declaration_text.h"

namespace merker::awl {
namespace {

using Bytes = std::span<const std::uint8_t>;

class ValueWriter {
 public:
  ValueWriter(Bytes declared, Bytes actual) : declared_(declared), actual_(actual) {}

  void variables(const std::vector<block::Variable>& list, const std::string& path, BitAddress at) {
    for (const block::Variable& v : list)
      if (v.section != block::Section::Temp) value(*v.type, path + v.name, at + v.address);
  }

  std::string text;

 private:
  void value(const block::Type& type, const std::string& path, BitAddress at) {
    if (type.code == TypeCode::Array) return array(type, path, at);
    if (!type.members.empty()) return variables(type.members, path + ".", at);
    const std::size_t size = block::sizeInBytes(type), first = at / 8;
    if (first + size > std::min(declared_.size(), actual_.size())) return;
    const Bytes now = actual_.subspan(first, size), then = declared_.subspan(first, size);
    const unsigned mask = type.code == TypeCode::Bool ? 1u << at % 8 : 0xFF;
    const bool same = std::equal(now.begin(), now.end(), then.begin(),
                                 [mask](auto a, auto b) { return ((a ^ b) & mask) == 0; });
    if (same) return;
    const std::string constant = valueText(type, now, at % 8);
    if (!constant.empty()) text += fmt::format("  {} := {};\n", path, constant);
  }

  void array(const block::Type& type, const std::string& path, BitAddress at) {
    std::vector<std::int32_t> index;
    for (const block::Dimension& d : type.dimensions) index.push_back(d.low);
    for (const BitAddress offset : block::elementOffsets(type)) {
      value(*type.element, fmt::format("{}[{}]", path, fmt::join(index, ",")), at + offset);
      for (std::size_t d = index.size(); d-- > 0;) {
        if (++index[d] <= type.dimensions[d].high) break;
        index[d] = type.dimensions[d].low;
      }
    }
  }

  Bytes declared_, actual_;
};

}  // namespace

std::string assignments(const block::Block& declared, Bytes actual) {
  ValueWriter writer(declared.actualData, actual);
  writer.variables(declared.variables, "", 0);
  return std::move(writer.text);
}

}  // namespace merker::awl
