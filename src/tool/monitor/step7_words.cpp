#include <fmt/format.h>

#include "base/text.h"
#include "monitor/filter_words.h"
#include "source/symbol_table.h"

namespace merker::monitor {
namespace {

using address::OperandKind;

constexpr AreaWord kStep7Areas[] = {
    {"E", OperandKind::Memory, Area::Input},  {"I", OperandKind::Memory, Area::Input},
    {"A", OperandKind::Memory, Area::Output}, {"Q", OperandKind::Memory, Area::Output},
    {"M", OperandKind::Memory, Area::Flag},   {"P", OperandKind::Memory, Area::Peripheral},
    {"T", OperandKind::Timer, Area::None},    {"Z", OperandKind::Counter, Area::None},
    {"C", OperandKind::Counter, Area::None}};
constexpr BlockKind kStep7Blocks[] = {BlockKind::OB, BlockKind::FC,  BlockKind::FB,
                                      BlockKind::DB, BlockKind::SFC, BlockKind::SFB};

// "DBW 4", "DIX 2.1": the number is that of MW 4, M 2.1.
std::optional<address::Operand> step7Data(std::string_view text) {
  const std::string word = upper(text.substr(0, 2));
  if ((word != "DB" && word != "DI") || text.size() < 4) return std::nullopt;
  constexpr std::string_view kWidths = "XBWD";
  const std::string letter = upper(text.substr(2, 1));
  if (kWidths.find(letter) == std::string_view::npos) return std::nullopt;
  const auto address = source::parseSymbolAddress(
      fmt::format("M{}{}", letter == "X" ? "" : letter, text.substr(3)), Position{});
  if (!address || address->kind != source::SymbolAddress::Kind::Memory) return std::nullopt;
  return address::memory(Area::DataBlock, address->width, address->address);
}

}  // namespace

const FilterWords& step7Words() {
  static constexpr FilterWords kWords{kStep7Areas, kStep7Blocks, step7Data};
  return kWords;
}

}  // namespace merker::monitor
