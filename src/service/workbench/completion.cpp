// What an editor can complete: symbols, blocks, instructions.
#include <algorithm>
#include <vector>

#include "mc7/encoding.h"
#include "workbench/program_rows.h"
#include "workbench/symbol_rows.h"

namespace merker::workbench {
namespace {

// Kinds of operands as words: what a name of operand_class.h begins with.
struct OperandRow {
  std::string_view operandClass, word;
};
constexpr OperandRow kOperands[] = {{"FlagBit", "bit"},
                                    {"FlagByte", "byte"},
                                    {"FlagWord", "word"},
                                    {"FlagDWord", "double word"},
                                    {"Bit", "bit"},
                                    {"Byte", "byte"},
                                    {"Word", "word"},
                                    {"DWord", "double word"},
                                    {"Timer", "timer"},
                                    {"Counter", "counter"},
                                    {"Constant", "constant"},
                                    {"Status", "status"},
                                    {"Jump", "label"},
                                    {"Count", "number"},
                                    {"Shift", "number"},
                                    {"Offset", "pointer"},
                                    {"Register", "AR2"},
                                    {"Db", "DB"},
                                    {"Di", "DI"},
                                    {"Fb", "FB"},
                                    {"Fc", "FC"},
                                    {"Sfc", "SFC"},
                                    {"Sfb", "SFB"},
                                    {"ParameterAddress", "parameter"}};

std::string_view wordOf(std::string_view operandClass) {
  for (const OperandRow& row : kOperands)
    if (operandClass.starts_with(row.operandClass)) return row.word;
  return {};
}

std::string operandsOf(mc7::Operation operation) {
  std::vector<std::string_view> words;
  for (const mc7::Encoding& row : mc7::encodings()) {
    if (row.operation != operation) continue;
    const std::string_view word = wordOf(row.operandClass);
    if (!word.empty() && std::ranges::find(words, word) == words.end()) words.push_back(word);
  }
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

Json instructions(Mnemonics mnemonics) {
  Json list = Json::array();
  for (std::size_t i = 0; i < mc7::operations().size(); ++i) {
    const mc7::OperationInfo& row = mc7::operations()[i];
    const std::string_view word = mnemonics == Mnemonics::German ? row.de : row.en;
    list.push_back({word, operandsOf(static_cast<mc7::Operation>(i)), row.id});
  }
  list.push_back({"CALL", "FB, FC, SFB, SFC", "CALL"});
  return list;
}

// The numbers that blocks can have: of OBs all there are, of the others the first and the last.
Json numbers(const CpuModel& model) {
  return {{"OB", model.organizationBlocks},
          {"FB", {0, model.highestFb}},
          {"FC", {0, model.highestFc}},
          {"DB", {1, model.highestDb}}};
}

// Of a data block with the parameters and static variables of a function block, this one.
std::string instanceOf(const block::Block& block) {
  if (block.instanceOf < 0) return {};
  return (block.instanceOfSystemBlock ? "SFB " : "FB ") + std::to_string(block.instanceOf);
}

Json blockEntry(BlockId id, const block::Block& block) {
  Json entry = {{"id", toString(id)},
                {"symbol", block.symbol.empty() ? block.attributes.name : block.symbol},
                {"title", block.attributes.title}};
  if (std::string own = instanceOf(block); !own.empty()) entry["instanceOf"] = std::move(own);
  return entry;
}

}  // namespace

Json completion(const compilation::Build& build) {
  static const Json words = {{"german", instructions(Mnemonics::German)},
                             {"international", instructions(Mnemonics::International)}};
  Json symbols = Json::array(), blocks = Json::array();
  for (const source::Symbol& symbol : build.project.symbols.list()) {
    SymbolRow row = symbolRow(symbol, source::Language::Step7);
    symbols.push_back({{"name", row.symbol},
                       {"operand", row.operand},
                       {"type", row.type},
                       {"comment", row.comment}});
  }
  for (const auto* program : {build.program.get(), build.library.get()})
    for (const auto& [id, block] : *program) blocks.push_back(blockEntry(id, block));
  return {{"symbols", std::move(symbols)},
          {"blocks", std::move(blocks)},
          {"mnemonics", words},
          {"numbers", numbers(*build.project.model)}};
}

}  // namespace merker::workbench
