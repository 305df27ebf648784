#include "monitor/data_structures.h"

#include <fmt/format.h>

#include "monitor/symbol_name.h"

namespace merker::monitor {
namespace {

using block::Type;

std::optional<BlockId> blockOf(const Type& type) {
  switch (type.code) {
    case TypeCode::Struct:
      if (type.udt < 0) return std::nullopt;
      return BlockId{BlockKind::UDT, static_cast<std::uint16_t>(type.udt)};
    case TypeCode::FunctionBlock:
      return BlockId{BlockKind::FB, type.length};
    case TypeCode::SystemFunctionBlock:
      return BlockId{BlockKind::SFB, type.length};
    default:
      return std::nullopt;
  }
}

class Walk {
 public:
  explicit Walk(const source::SymbolTable& symbols) : symbols_(symbols) {}

  void members(const std::vector<block::Variable>& list, const std::string& before) {
    for (const block::Variable& one : list)
      if (one.section != block::Section::Temp) type(*one.type, before + one.name);
  }

  std::vector<DataStructure> found;

 private:
  void type(const Type& type, const std::string& path) {
    if (type.code == TypeCode::Array) return this->type(*type.element, path + "[]");
    if (const auto id = blockOf(type)) found.push_back({path, nameOf(*id)});
    members(type.members, path + ".");
  }

  std::string nameOf(BlockId id) const {
    const source::Symbol* symbol = findSymbol(id, symbols_);
    return symbol == nullptr ? toString(id) : fmt::format("\"{}\"", symbol->name);
  }

  const source::SymbolTable& symbols_;
};

}  // namespace

std::vector<DataStructure> dataStructures(const block::Block& block,
                                          const source::SymbolTable& symbols) {
  Walk walk(symbols);
  walk.members(block.variables, "");
  return std::move(walk.found);
}

}  // namespace merker::monitor
