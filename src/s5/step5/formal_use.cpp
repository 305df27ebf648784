#include "step5/formal_use.h"

#include <algorithm>
#include <array>

namespace merker::step5 {
namespace {

using mc5::Operation;
using mc5::Parameter;
using mc5::ParameterKind;

bool isAddress(const Parameter& p) {
  return p.kind == ParameterKind::Input || p.kind == ParameterKind::Output;
}
bool isBit(const Parameter& p) { return isAddress(p) && p.width == mc5::Width::Bit; }
bool isValue(const Parameter& p) { return isAddress(p) && p.width != mc5::Width::Bit; }
bool isTimer(const Parameter& p) { return p.kind == ParameterKind::Timer; }
bool isCell(const Parameter& p) { return isTimer(p) || p.kind == ParameterKind::Counter; }
bool isBitOrCell(const Parameter& p) { return isBit(p) || isCell(p); }
bool isBlock(const Parameter& p) { return p.kind == ParameterKind::Block; }
bool isFloat(const Parameter& p) {
  return p.kind == ParameterKind::Data && p.format == mc5::Format::Float;
}
// LW loads the word of the list as it is: of FB 140 (6.3) also that of a block and of a byte.
bool isWord(const Parameter& p) { return !isFloat(p); }

struct Use {
  bool (*takes)(const Parameter&);
  std::string_view kinds;
};
constexpr Use kBit{isBit, "E BI, A BI"}, kBitOrCell{isBitOrCell, "E BI, A BI, T, Z"},
    kValue{isValue, "E and A with BY, W, D"}, kTimer{isTimer, "T"}, kCell{isCell, "T, Z"},
    kWord{isWord, "D KM KH KY KC KT KZ KF, and all others but D KG"}, kFloat{isFloat, "D KG"},
    kBlock{isBlock, "B"};

struct Row {
  Operation operation;
  Use use;
};
constexpr std::array kRows{Row{Operation::AND, kBitOrCell},  Row{Operation::AND_NOT, kBitOrCell},
                           Row{Operation::OR, kBitOrCell},   Row{Operation::OR_NOT, kBitOrCell},
                           Row{Operation::SET_BIT, kBit},    Row{Operation::RESET_FORMAL_BIT, kBit},
                           Row{Operation::ASSIGN, kBit},     Row{Operation::LOAD, kValue},
                           Row{Operation::TRANSFER, kValue}, Row{Operation::LOAD_BCD, kCell},
                           Row{Operation::LOAD_WORD, kWord}, Row{Operation::LOAD_DOUBLE, kFloat},
                           Row{Operation::TIMER_SI, kTimer}, Row{Operation::TIMER_SE, kTimer},
                           Row{Operation::ENABLE, kCell},    Row{Operation::RESET_DIGITAL, kCell},
                           Row{Operation::START_SVZ, kCell}, Row{Operation::START_SSV, kCell},
                           Row{Operation::START_SAR, kCell}, Row{Operation::SUBSTITUTE, kBlock}};

}  // namespace

std::string_view kindsInstead(Operation operation, const Parameter& parameter) {
  const auto* row = std::find_if(kRows.begin(), kRows.end(),
                                 [&](const Row& r) { return r.operation == operation; });
  const bool fits = row == kRows.end() || row->use.takes(parameter);
  return fits ? std::string_view() : row->use.kinds;
}

}  // namespace merker::step5
