// Parts of a cross reference list: by operand, symbols nobody uses, operands without symbol.
#include <algorithm>
#include <functional>
#include <set>

#include "base/text.h"
#include "monitor/cross_reference.h"
#include "monitor/symbol_name.h"

namespace merker::monitor {
namespace {

using address::isMemory;
using Accept = std::function<bool(const CrossReference&)>;

std::uint32_t bits(Width width) { return width == Width::Bit ? 1 : 8 * byteCount(width); }
std::uint32_t bits(const CrossReference& r) { return r.bits != 0 ? r.bits : bits(r.key.width); }

bool isData(const CrossReference& r) {
  return isMemory(r.key) && (r.key.area == Area::DataBlock || r.key.area == Area::Instance);
}

// Whether an access touches one of these bits; the area is known.
bool overlaps(const CrossReference& r, const address::Operand& wanted) {
  return r.key.value < wanted.value + bits(wanted.width) && wanted.value < r.key.value + bits(r);
}

Accept overlapping(const address::Operand& wanted, std::int32_t db) {
  return [wanted, db](const CrossReference& r) {
    if (r.key.kind != wanted.kind) return false;
    if (!isMemory(wanted)) return r.key.value == wanted.value;
    return r.key.area == wanted.area && r.db == db && overlaps(r, wanted);
  };
}

// A reference beside the program of this PLC is none of its operands.
Accept overlapping(const address::Reference& wanted) {
  if (wanted.partner || wanted.nc != 0) return [](const CrossReference&) { return false; };
  return overlapping(wanted.operand, wanted.db);
}

std::optional<Accept> wholeArea(std::string_view text, const FilterWords& words) {
  for (const AreaWord& row : words.areas)
    if (equalsIgnoreCase(row.word, text))
      return [row](const CrossReference& r) {
        return r.key.kind == row.kind && r.key.area == row.area;
      };
  for (const BlockKind kind : words.blocks)
    if (equalsIgnoreCase(merker::name(kind), text))
      return [kind](const CrossReference& r) {
        return (r.formal == 0 && r.block && r.block->kind == kind) ||
               (kind == BlockKind::DB && r.db >= 0);
      };
  return std::nullopt;
}

Accept toBlock(BlockId id) {
  return [id](const CrossReference& r) {
    if (r.block) return r.formal == 0 && *r.block == id;
    return id.kind == BlockKind::DB && r.db == id.number;
  };
}

Accept toData(const address::Operand& operand) {
  return [operand](const CrossReference& r) { return isData(r) && overlaps(r, operand); };
}

// The resolver knows the names of values outside data blocks.
std::optional<Accept> symbolOf(std::string_view text, const source::SymbolTable& symbols) {
  using Kind = source::SymbolAddress::Kind;
  const source::Symbol* const symbol = writtenSymbol(text, symbols);
  if (symbol == nullptr) return std::nullopt;
  const source::SymbolAddress& at = symbol->address;
  if (at.kind == Kind::Block) return toBlock(at.block);
  if (at.kind != Kind::Memory || at.area != Area::DataBlock) return std::nullopt;
  return toData(address::memory(at.area, at.width, at.address));
}

// PB 5 is the program block and the byte of the periphery: the instruction decides.
std::optional<Accept> blockOf(std::string_view text, const FilterWords& words) {
  const auto wanted = parseBlockId(text, words.blocks);
  if (!wanted) return std::nullopt;
  const Accept byte =
      overlapping(address::memory(Area::Peripheral, Width::Byte, bitAddress(wanted->number)), -1);
  return [id = *wanted, block = toBlock(*wanted), byte](const CrossReference& r) {
    return block(r) || (!r.block && id.kind == BlockKind::PB && byte(r));
  };
}

std::optional<Accept> dataOf(std::string_view text, const FilterWords& words) {
  const auto wanted = words.data(text);
  if (!wanted) return std::nullopt;
  return toData(*wanted);
}

std::optional<Accept> formalOf(std::string_view text) {
  if (!text.starts_with('=') || text.size() < 2) return std::nullopt;
  return [name = std::string(text)](const CrossReference& r) {
    return r.formal != 0 && equalsIgnoreCase(r.operand, name);
  };
}

// Data, ranges and formal operands never have a symbol of their own.
bool hasSymbols(const CrossReference& r) {
  return r.key.kind != address::OperandKind::None && r.bits == 0 && !isData(r);
}

}  // namespace

const FilterWords& filterWords(const ProgramCode& program) {
  return program.unit() == CodeUnit::Byte ? step7Words() : step5Words();
}

Result<std::vector<CrossReference>> filtered(const std::vector<CrossReference>& list,
                                             std::string_view filter,
                                             const simulator::Resolver& resolver,
                                             const FilterWords& words,
                                             const source::SymbolTable& symbols) {
  std::vector<Accept> accepts;
  for (std::size_t begin = 0; begin <= filter.size();) {
    const std::size_t end = std::min(filter.find(',', begin), filter.size());
    const std::string_view part = trim(filter.substr(begin, end - begin));
    begin = end + 1;
    std::optional<Accept> accept = wholeArea(part, words);
    if (!accept) accept = blockOf(part, words);
    if (!accept) accept = dataOf(part, words);
    if (!accept) accept = formalOf(part);
    if (!accept) accept = symbolOf(part, symbols);
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
