#include "mc7/operand_text.h"

#include <fmt/format.h>

#include <array>

namespace merker::mc7 {
namespace {

struct Context {
  const Operand& operand;
  bool stores;  // a transfer: the periphery is PA
  Mnemonics mnemonics;

  bool german() const { return mnemonics == Mnemonics::German; }
};

using Printer = std::string (*)(const Context&);

constexpr std::array<std::string_view, 4> kWidthLetters{"X", "B", "W", "D"};

std::string_view widthLetter(Width width) { return kWidthLetters[static_cast<std::size_t>(width)]; }

std::string_view peripheryName(const Context& c) {
  if (c.stores) return c.german() ? "PA" : "PQ";
  return c.german() ? "PE" : "PI";
}

// "M" and "DBX" for bits, "MW" and "DBW" for a word.
std::string operandName(Area area, Width width, const Context& c) {
  const bool data = area == Area::DataBlock || area == Area::Instance;
  const std::string_view name =
      area == Area::Peripheral ? peripheryName(c) : areaName(area, c.mnemonics);
  return fmt::format("{}{}", name, width == Width::Bit && !data ? "" : widthLetter(width));
}
std::string operandName(const Context& c) {
  return operandName(c.operand.area, c.operand.width, c);
}

std::string bitText(BitAddress address) { return fmt::format("{}.{}", address / 8, address % 8); }

// "[MD 4]", with numbers (timer, block) "[MW 4]".
std::string memoryPointer(Width width, const Context& c) {
  return fmt::format("[{} {}]", operandName(c.operand.pointerArea, width, c), c.operand.value);
}
std::string registerPointer(const Context& c) {
  return fmt::format("[AR{},P#{}]", c.operand.reg, bitText(c.operand.value));
}

std::string_view counterName(const Context& c) { return c.german() ? "Z" : "C"; }

std::string_view blockName(const Context& c) {
  return c.operand.blockKind == BlockKind::DB && c.operand.reg != 0 ? "DI"
                                                                    : name(c.operand.blockKind);
}

std::string numbered(std::string_view word, const Context& c) {
  return fmt::format("{} {}", word, c.operand.value);
}
std::string inMemory(std::string_view word, const Context& c) {
  return fmt::format("{} {}", word, memoryPointer(Width::Word, c));
}
std::string formal(std::string_view word, const Context& c) {
  return fmt::format("{}{}#P{}", word, word.empty() ? "" : " ", c.operand.value);
}

std::string none(const Context&) { return {}; }
std::string memoryText(const Context& c) {
  const bool bit = c.operand.width == Width::Bit;
  return fmt::format("{} {}", operandName(c),
                     bit ? bitText(c.operand.value) : std::to_string(c.operand.value / 8));
}
std::string memoryIndirectText(const Context& c) {
  return fmt::format("{} {}", operandName(c), memoryPointer(Width::DWord, c));
}
std::string registerIndirectText(const Context& c) {
  return fmt::format("{} {}", operandName(c), registerPointer(c));
}
std::string registerCrossingText(const Context& c) {
  if (c.operand.width == Width::Bit) return registerPointer(c);
  return fmt::format("{} {}", widthLetter(c.operand.width), registerPointer(c));
}
std::string parameterText(const Context& c) {
  return formal(c.operand.width == Width::Bit ? "" : widthLetter(c.operand.width), c);
}
std::string timerText(const Context& c) { return numbered("T", c); }
std::string timerIndirectText(const Context& c) { return inMemory("T", c); }
std::string timerParameterText(const Context& c) { return formal("T", c); }
std::string counterText(const Context& c) { return numbered(counterName(c), c); }
std::string counterIndirectText(const Context& c) { return inMemory(counterName(c), c); }
std::string counterParameterText(const Context& c) { return formal(counterName(c), c); }

std::string statusBitText(const Context& c) {
  static constexpr std::array<std::string_view, 16> kNames{
      "OS", "OV", ">0", "", "<0", "UO", "<>0", "", "==0", "", ">=0", "", "<=0", "", "", ""};
  if (static_cast<StatusQuery>(c.operand.value) == StatusQuery::BIE)
    return c.german() ? "BIE" : "BR";
  return std::string{kNames[c.operand.value % kNames.size()]};
}
std::string statusWordText(const Context&) { return "STW"; }

std::string constantText(const Context& c) {
  if (isAnyHeader(c.operand)) return fmt::format("ANY#16#{:04X}", c.operand.value);
  return formatConstant({c.operand.format, c.operand.value}, c.mnemonics);
}
std::string offsetText(const Context& c) {
  return pointerText(Area::None, c.operand.value, c.mnemonics);
}
std::string addressRegisterText(const Context& c) { return fmt::format("AR{}", c.operand.reg); }
std::string numberText(const Context& c) { return std::to_string(c.operand.value); }
std::string jumpText(const Context& c) {
  return std::to_string(static_cast<std::int32_t>(c.operand.value));
}
std::string blockText(const Context& c) { return numbered(blockName(c), c); }
std::string blockIndirectText(const Context& c) { return inMemory(blockName(c), c); }
std::string blockParameterText(const Context& c) { return formal(blockName(c), c); }
std::string parameterAddressText(const Context& c) {
  return fmt::format("P##P{}", c.operand.value);
}
std::string dataBlockInfoText(const Context& c) {
  static constexpr std::array<std::string_view, 4> kNames{"DBLG", "DILG", "DBNO", "DINO"};
  return std::string{kNames[c.operand.value % kNames.size()]};
}

// In the order of OperandKind.
constexpr std::array<Printer, 25> kPrinters{none,
                                            memoryText,
                                            memoryIndirectText,
                                            registerIndirectText,
                                            registerCrossingText,
                                            parameterText,
                                            timerText,
                                            timerIndirectText,
                                            timerParameterText,
                                            counterText,
                                            counterIndirectText,
                                            counterParameterText,
                                            statusBitText,
                                            statusWordText,
                                            constantText,
                                            offsetText,
                                            addressRegisterText,
                                            numberText,
                                            jumpText,
                                            numberText,
                                            blockText,
                                            blockIndirectText,
                                            blockParameterText,
                                            parameterAddressText,
                                            dataBlockInfoText};
static_assert(kPrinters.size() == static_cast<std::size_t>(OperandKind::DataBlockInfo) + 1);

}  // namespace

std::string_view areaName(Area area, Mnemonics mnemonics) {
  const bool german = mnemonics == Mnemonics::German;
  switch (area) {
    case Area::None:
      return "";
    case Area::Peripheral:
      return "P";
    case Area::Input:
      return german ? "E" : "I";
    case Area::Output:
      return german ? "A" : "Q";
    case Area::Flag:
      return "M";
    case Area::DataBlock:
      return "DB";
    case Area::Instance:
      return "DI";
    case Area::Local:
      return "L";
    case Area::CallerLocal:
      return "V";
  }
  return "";
}

std::string pointerText(Area area, BitAddress address, Mnemonics mnemonics) {
  if (area == Area::None) return fmt::format("P#{}", bitText(address));
  const bool data = area == Area::DataBlock || area == Area::Instance;
  return fmt::format("P#{}{} {}", areaName(area, mnemonics), data ? "X" : "", bitText(address));
}

std::string operandText(const Instruction& instruction, Mnemonics mnemonics) {
  const Context context{instruction.operand, instruction.operation == Operation::TRANSFER,
                        mnemonics};
  return kPrinters[static_cast<std::size_t>(instruction.operand.kind)](context);
}

}  // namespace merker::mc7
