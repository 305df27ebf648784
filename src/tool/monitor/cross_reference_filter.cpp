// Parts of a cross reference list: by operand, symbols nobody uses, operands without symbol.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "base/text.h"
#include "mc7/place.h"
#include "monitor/cross_reference.h"

namespace merker::monitor {
namespace {

using mc7::OperandKind;
using Accept = std::function<bool(const CrossReference&)>;

struct AreaWord {
  std::string_view word;
  OperandKind kind;
  Area area;  // Memory
};
constexpr AreaWord kAreaWords[] = {
    {"E", OperandKind::Memory, Area::Input},  {"I", OperandKind::Memory, Area::Input},
    {"A", OperandKind::Memory, Area::Output}, {"Q", OperandKind::Memory, Area::Output},
    {"M", OperandKind::Memory, Area::Flag},   {"P", OperandKind::Memory, Area::Peripheral},
    {"T", OperandKind::Timer, Area::None},    {"Z", OperandKind::Counter, Area::None},
    {"C", OperandKind::Counter, Area::None}};
constexpr BlockKind kKinds[] = {BlockKind::OB, BlockKind::FC,  BlockKind::FB,
                                BlockKind::DB, BlockKind::SFC, BlockKind::SFB};

std::optional<Accept> wholeArea(std::string_view text) {
  for (const AreaWord& row : kAreaWords)
    if (equalsIgnoreCase(row.word, text))
      return [row](const CrossReference& r) {
        return r.key.kind == row.kind && r.key.area == row.area;
      };
  for (const BlockKind kind : kKinds)
    if (equalsIgnoreCase(merker::name(kind), text))
      return [kind](const CrossReference& r) {
        return (r.key.kind == OperandKind::Block && r.key.blockKind == kind) ||
               (kind == BlockKind::DB && r.db >= 0);
      };
  return std::nullopt;
}

std::optional<Accept> blockOf(std::string_view text) {
  const auto address = source::parseSymbolAddress(text, Position{});
  if (!address || address->kind != source::SymbolAddress::Kind::Block) return std::nullopt;
  return [id = address->block](const CrossReference& r) {
    if (r.key.kind == OperandKind::Block)
      return r.key.blockKind == id.kind && r.key.value == id.number;
    return id.kind == BlockKind::DB && r.db == id.number;
  };
}

std::uint32_t bits(Width width) { return width == Width::Bit ? 1 : 8 * byteCount(width); }
std::uint32_t bits(const CrossReference& r) { return r.bits != 0 ? r.bits : bits(r.key.width); }

// "DBW 4", "DIX 2.1": of any data block.
std::optional<Accept> dataOf(std::string_view text) {
  const std::string word = upper(text.substr(0, 2));
  if ((word != "DB" && word != "DI") || text.size() < 4) return std::nullopt;
  constexpr std::string_view kWidths = "XBWD";
  const std::size_t width = kWidths.find(upper(text.substr(2, 1)));
  const auto address =
      width == std::string_view::npos
          ? Result<source::SymbolAddress>(makeProblem(ProblemCode::P0317, Position{}, ""))
          : source::parseSymbolAddress(
                fmt::format("M{}{}", width == 0 ? "" : std::string(text.substr(2, 1)),
                            text.substr(3)),
                Position{});
  if (!address || address->kind != source::SymbolAddress::Kind::Memory) return std::nullopt;
  const mc7::Operand wanted = mc7::memory(Area::Flag, address->width, address->address);
  return [wanted](const CrossReference& r) {
    return r.key.kind == OperandKind::Memory &&
           (r.key.area == Area::DataBlock || r.key.area == Area::Instance) &&
           r.key.value < wanted.value + bits(wanted.width) && wanted.value < r.key.value + bits(r);
  };
}

Accept overlapping(const address::Reference& wanted) {
  return [operand = wanted.operand, db = wanted.db](const CrossReference& r) {
    if (mc7::placeOf(r.key).kind != operand.kind) return false;
    if (!isMemory(operand)) return r.key.value == operand.value;
    return r.key.area == operand.area && r.db == db &&
           r.key.value < operand.value + bits(operand.width) &&
           operand.value < r.key.value + bits(r);
  };
}

// Data and ranges never have a symbol of their own.
bool hasSymbols(const CrossReference& r) {
  const bool data = r.key.area == Area::DataBlock || r.key.area == Area::Instance;
  return r.key.kind != OperandKind::Block && r.bits == 0 &&
         !(r.key.kind == OperandKind::Memory && data);
}

}  // namespace

Result<std::vector<CrossReference>> filtered(const std::vector<CrossReference>& list,
                                             std::string_view filter,
                                             const simulator::Resolver& resolver) {
  std::vector<Accept> accepts;
  for (std::size_t begin = 0; begin <= filter.size();) {
    const std::size_t end = std::min(filter.find(',', begin), filter.size());
    const std::string_view part = trim(filter.substr(begin, end - begin));
    begin = end + 1;
    std::optional<Accept> accept = wholeArea(part);
    if (!accept) accept = blockOf(part);
    if (!accept) accept = dataOf(part);
    if (!accept) {
      const auto reference = resolver(part, Position{"", 0, 0, 0});
      if (!reference) return reference.error();
      accept = overlapping(*reference);
      if (part.starts_with('#') && std::ranges::none_of(list, *accept))
        return makeProblem(ProblemCode::P1218, Position{"", 0, 0, 0}, std::string(part));
    }
    accepts.push_back(std::move(*accept));
  }
  std::vector<CrossReference> result;
  for (const CrossReference& row : list)
    if (std::ranges::any_of(accepts, [&](const Accept& accept) { return accept(row); }))
      result.push_back(row);
  return result;
}

std::vector<source::Symbol> unusedSymbols(const std::vector<CrossReference>& list,
                                          const source::SymbolTable& symbols) {
  std::set<std::string> used;
  for (const CrossReference& row : list) used.insert(row.symbol);
  std::vector<source::Symbol> result;
  for (const source::Symbol& symbol : symbols.list()) {
    const bool ob = symbol.address.kind == source::SymbolAddress::Kind::Block &&
                    symbol.address.block.kind == BlockKind::OB;  // the operating system calls it
    if (!ob && !used.contains(symbol.name)) result.push_back(symbol);
  }
  return result;
}

std::vector<std::string> operandsWithoutSymbol(const std::vector<CrossReference>& list) {
  std::vector<std::string> result;
  for (const CrossReference& row : list)
    if (row.symbol.empty() && hasSymbols(row) && (result.empty() || result.back() != row.operand))
      result.push_back(row.operand);
  return result;
}

}  // namespace merker::monitor
