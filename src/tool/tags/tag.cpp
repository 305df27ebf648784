#include "tags/tag.h"

#include <fmt/ranges.h>

#include "block/elements.h"

namespace merker::tags {
namespace {

using Kind = source::SymbolAddress::Kind;

std::optional<TagArea> areaOf(const source::SymbolAddress& address) {
  if (address.kind == Kind::Timer) return TagArea::Timer;
  if (address.kind == Kind::Counter) return TagArea::Counter;
  if (address.kind != Kind::Memory) return std::nullopt;
  if (address.area == Area::Peripheral)
    return address.peripheralOutput ? TagArea::PeripheralOutput : TagArea::PeripheralInput;
  if (address.area == Area::Input) return TagArea::Input;
  if (address.area == Area::Output) return TagArea::Output;
  if (address.area == Area::Flag) return TagArea::Flag;
  return std::nullopt;
}

void addSymbols(const source::SymbolTable& symbols, std::vector<Tag>& list) {
  for (const source::Symbol& symbol : symbols.list()) {
    const std::optional<TagArea> area = areaOf(symbol.address);
    if (!area) continue;
    const bool numbered = *area == TagArea::Timer || *area == TagArea::Counter;
    list.push_back({.path = {symbol.name},
                    .area = *area,
                    .at = numbered ? symbol.address.number : symbol.address.address,
                    .type = symbol.type,
                    .comment = symbol.comment,
                    .writable = *area != TagArea::PeripheralInput,
                    .readable = *area != TagArea::PeripheralOutput});
  }
}

// "a.b[1].c" as its parts.
std::vector<std::string> parts(const std::string& name, const std::string& path) {
  std::vector<std::string> list{name};
  std::size_t begin = 0;
  for (std::size_t dot = 0; dot != std::string::npos; begin = dot + 1) {
    dot = path.find('.', begin);
    list.push_back(path.substr(begin, dot - begin));
  }
  return list;
}

// A source may declare a block by its number although it has a symbol.
std::string nameOf(const block::Block& db, const source::SymbolTable& symbols) {
  if (!db.symbol.empty()) return db.symbol;
  const auto* const symbol = symbols.findAddress({.kind = Kind::Block, .block = db.id});
  return symbol != nullptr ? symbol->name : fmt::format("DB{}", db.id.number);
}

void addData(const block::Block& db, const std::string& name, std::vector<Tag>& list) {
  block::forEachElement(db.variables, [&](const block::Element& element) {
    list.push_back({.path = parts(name, element.path),
                    .area = TagArea::Data,
                    .db = db.id.number,
                    .at = element.at,
                    .type = element.type.code,
                    .length = element.type.length,
                    .comment = element.name.comment,
                    .writable = !db.attributes.readOnly});
    return true;
  });
}

}  // namespace

std::vector<Tag> listTags(const compilation::Build& build, const TagOptions& options) {
  std::vector<Tag> list;
  addSymbols(build.project.symbols, list);
  if (!options.data || !build.program) return list;
  for (const auto& [id, block] : *build.program)
    if (id.kind == BlockKind::DB && !block.attributes.unlinked)
      addData(block, nameOf(block, build.project.symbols), list);
  return list;
}

std::string fullName(const Tag& tag) { return fmt::format("{}", fmt::join(tag.path, ".")); }

}  // namespace merker::tags
