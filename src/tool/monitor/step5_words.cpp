#include <string>

#include "monitor/filter_words.h"
#include "step5/variable.h"

namespace merker::monitor {
namespace {

using address::OperandKind;

constexpr AreaWord kStep5Areas[] = {
    {"E", OperandKind::Memory, Area::Input},     {"A", OperandKind::Memory, Area::Output},
    {"M", OperandKind::Memory, Area::Flag},      {"P", OperandKind::Memory, Area::Peripheral},
    {"D", OperandKind::Memory, Area::DataBlock}, {"T", OperandKind::Timer, Area::None},
    {"Z", OperandKind::Counter, Area::None}};
constexpr BlockKind kStep5Blocks[] = {BlockKind::OB, BlockKind::PB, BlockKind::SB, BlockKind::FB,
                                      BlockKind::DB};

// "DW 4", "D 2.15"
std::optional<address::Operand> step5Data(std::string_view text) {
  const auto variable = step5::parseVariable("DB 0." + std::string(text));
  return variable ? std::optional(variable->operand) : std::nullopt;
}

}  // namespace

const FilterWords& step5Words() {
  static constexpr FilterWords kWords{kStep5Areas, kStep5Blocks, step5Data};
  return kWords;
}

}  // namespace merker::monitor
