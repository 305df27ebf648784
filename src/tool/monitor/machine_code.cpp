#include "monitor/machine_code.h"

#include "mc5/disassembly.h"
#include "mc7/disassembly.h"
#include "monitor/data_rows.h"

namespace merker::monitor {
namespace {

using Rows = std::vector<MachineCodeRow>;

std::string wordsOf(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    text += fmt::format("{}{:02X}", i > 0 && i % 2 == 0 ? " " : "", bytes[i]);
  return text;
}

std::string wordsOf(std::span<const std::uint16_t> words) {
  std::string text;
  for (const std::uint16_t word : words)
    text += fmt::format("{}{:04X}", text.empty() ? "" : " ", word);
  return text;
}

Rows rowsOf(const block::Block& block, Mnemonics mnemonics) {
  if (block.code.empty()) return dataRows(block);
  Rows rows;
  for (const mc7::Line& line : mc7::disassemble(block.code, mnemonics))
    rows.push_back({line.offset, wordsOf(line.bytes), line.text, 0});
  return rows;
}

Rows rowsOf(const mc5::Block& block) {
  if (block.id.type == mc5::BlockType::Db) return dataRows(block);
  Rows rows;
  for (const mc5::Line& line : mc5::disassemble(block.words))
    rows.push_back({line.offset, wordsOf(line.words), line.text, 0});
  return rows;
}

}  // namespace

Rows machineCode(const BlockCode& code, Mnemonics mnemonics) {
  Rows rows = code.s7() != nullptr ? rowsOf(*code.s7(), mnemonics) : rowsOf(*code.s5());
  std::size_t next = 0;
  std::uint32_t line = 0;
  bool own = true;  // a statement of the source begins there
  for (MachineCodeRow& row : rows) {
    own = false;
    for (; next < code.lineCount() && code.line(next).offset <= row.offset; ++next) {
      line = code.line(next).line;
      own = true;
    }
    row.line = line;
  }
  if (!own && rows.back().text == "BE") rows.back().line = 0;
  return rows;
}

}  // namespace merker::monitor
