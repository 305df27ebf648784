#include "awl/data_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "awl/declaration_text.h"

namespace merker::awl {
namespace {

using Bytes = std::span<const std::uint8_t>;

// What is no date is shown as 16#…, which is no constant of the type.
bool isConstant(const block::Type& type, std::string_view text) {
  return !text.empty() && (type.code != TypeCode::DateAndTime || text.starts_with("DT#"));
}

class ValueWriter {
 public:
  ValueWriter(Bytes declared, Bytes actual, Bytes before)
      : declared_(declared), actual_(actual), before_(before) {}

  void variables(const std::vector<block::Variable>& list, const std::string& path, BitAddress at) {
    for (const block::Variable& v : list)
      if (v.section != block::Section::Temp) value(*v.type, path + v.name, at + v.address);
  }

  Assignments result;

 private:
  void value(const block::Type& type, const std::string& path, BitAddress at) {
    if (type.code == TypeCode::Array) return array(type, path, at);
    if (!type.members.empty()) return variables(type.members, path + ".", at);
    const std::size_t size = block::sizeInBytes(type), first = at / 8;
    if (first + size > std::min(declared_.size(), actual_.size())) return;
    const auto part = [&](Bytes all) { return all.subspan(first, size); };
    const auto changed = [&, mask = type.code == TypeCode::Bool ? 1u << at % 8 : 0xFF](Bytes now) {
      return !std::ranges::equal(now, part(declared_),
                                 [mask](auto a, auto b) { return ((a ^ b) & mask) == 0; });
    };
    const Bytes now = part(actual_);
    if (!changed(now) || assign(type, path, now, at % 8)) return;
    result.without.push_back(path);
    if (first + size > before_.size()) return;
    if (const Bytes before = part(before_); changed(before)) assign(type, path, before, at % 8);
  }

  // Whether a constant says these bytes.
  bool assign(const block::Type& type, const std::string& path, Bytes bytes, unsigned bit) {
    const std::string constant = valueText(type, bytes, bit);
    if (!isConstant(type, constant)) return false;
    result.text += fmt::format("  {} := {};\n", path, constant);
    return true;
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

  Bytes declared_, actual_, before_;
};

}  // namespace

Assignments assignments(const block::Block& declared, Bytes actual, Bytes before) {
  ValueWriter writer(declared.actualData, actual, before);
  writer.variables(declared.variables, "", 0);
  return std::move(writer.result);
}

}  // namespace merker::awl
