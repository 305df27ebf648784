#include "workbench/program_rows.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "block/container.h"
#include "mc5/block_id.h"
#include "mc5/disassembly.h"
#include "mc7/disassembly.h"
#include "mc7/listing.h"
#include "monitor/block_list.h"
#include "monitor/machine_code.h"
#include "monitor/step5_code.h"
#include "monitor/symbol_name.h"
#include "step5/block_source.h"

namespace merker::workbench {
namespace {

bool isCall(mc7::Operation operation) {
  return operation == mc7::Operation::UC || operation == mc7::Operation::CC;
}

Json callsOf(const block::Block& block) {
  std::set<BlockId> called;
  for (const mc7::Place& place : mc7::list(block.code).places) {
    const mc7::Operand& operand = place.instruction.operand;
    if (place.known && isCall(place.instruction.operation) &&
        operand.kind == mc7::OperandKind::Block)
      called.insert({operand.blockKind, static_cast<std::uint16_t>(operand.value)});
  }
  Json list = Json::array();
  for (const BlockId id : called) list.push_back(toString(id));
  return list;
}

// With the function blocks of the basic program.
Json callsOf(const mc5::Block& block) {
  std::set<BlockId> called;
  for (const monitor::Step5Instruction& one : monitor::step5Instructions(block)) {
    const mc5::Operand& operand = one.instruction.operand;
    if (operand.kind != mc5::OperandKind::Block || operand.block == mc5::BlockType::Db) continue;
    called.insert(mc5::neutralId({operand.block, static_cast<std::uint16_t>(operand.value)}));
  }
  Json list = Json::array();
  for (const BlockId id : called) list.push_back(toString(id));
  return list;
}

std::string_view languageOf(const block::Block& block) {
  if (block.id.kind == BlockKind::DB) return "DB";
  return block.id.kind == BlockKind::UDT ? "UDT" : "AWL";
}

// The first thing that differs, as a person would look for it; empty if nothing does.
std::string difference(const block::Block& a, const block::Block& b) {
  if (a.code != b.code) {
    const auto at = std::ranges::mismatch(a.code, b.code);
    const auto byte = static_cast<std::uint32_t>(at.in1 - a.code.begin());
    return fmt::format("code from byte {} (line {})", byte, a.line(byte));
  }
  if (a.localBytes != b.localBytes) return "local data";
  if (a.actualData != b.actualData || a.initialData != b.initialData) return "values";
  return block::writeContainer(a) == block::writeContainer(b) ? "" : "interface or properties";
}

bool sameParameter(const mc5::Parameter& a, const mc5::Parameter& b) {
  return std::tie(a.name, a.kind, a.width, a.format) == std::tie(b.name, b.kind, b.width, b.format);
}

std::string difference(const mc5::Block& a, const mc5::Block& b) {
  if (a.words != b.words) {
    if (a.id.type == mc5::BlockType::Db) return "values";
    const auto at = std::ranges::mismatch(a.words, b.words);
    return fmt::format("code from word {}", at.in1 - a.words.begin());
  }
  const bool same =
      a.name == b.name && std::ranges::equal(a.parameters, b.parameters, sameParameter);
  return same ? "" : "interface or properties";
}

std::string dataText(const block::Block& block) {
  std::string text;
  for (std::size_t i = 0; i < block.actualData.size(); ++i) {
    if (i % 16 == 0) text += fmt::format("{}DBB {:<5}", i == 0 ? "" : "\n", i);
    text += fmt::format(" {:02X}", block.actualData[i]);
  }
  return text + "\n";
}

// A UDT exists in the project only.
bool isLoaded(BlockId id) { return id.kind != BlockKind::UDT; }
bool isLoaded(mc5::BlockId) { return true; }

}  // namespace

Json blockRows(const block::Program& program, const std::map<BlockId, BlockSource>& sources,
               const ProjectFolder& folder, bool cpu) {
  Json list = Json::array();
  for (const auto& [id, block] : program) {
    if (cpu && !isLoaded(id)) continue;
    const monitor::BlockRow row = monitor::blockRow(block);
    const auto source = sources.find(id);
    const bool known = source != sources.end();
    list.push_back({{"id", toString(id)},
                    {"symbol", row.symbol},
                    {"title", block.attributes.title},
                    {"language", languageOf(block)},
                    {"load", row.load},
                    {"work", row.work},
                    {"file", folder.relative(known ? source->second.file : block.file)},
                    {"line", known ? source->second.line : 0},
                    {"calls", callsOf(block)},
                    {"version", row.version},
                    {"checksum", fmt::format("{:04X}", row.checksum)}});
  }
  return list;
}

namespace {

// Of its first network; else the first comment, which stands above the block or beside its head.
std::string titleOf(const mc5::Block& block) {
  if (!block.networks.empty() && !block.networks.front().title.empty())
    return block.networks.front().title;
  const bool above = !block.comments.empty() && block.comments.front().offset == 0 &&
                     !block.comments.front().behind;
  if (!above) return {};
  const std::string& text = block.comments.front().text;
  return text.substr(std::min(text.find_first_not_of("!;/ "), text.size()));
}

// Lines of the heads, for a file and its block.
std::map<std::pair<std::string, mc5::BlockId>, std::uint32_t> headLines(
    const std::vector<source::SourceFile>& sources) {
  std::map<std::pair<std::string, mc5::BlockId>, std::uint32_t> lines;
  Problems ignored;  // program.check tells them
  for (const source::SourceFile& file : sources)
    for (const step5::BlockSource& one : step5::findBlocks(file, ignored))
      lines.try_emplace({file.name(), one.id}, file.position(one.offset, one.length).line);
  return lines;
}

}  // namespace

Json blockRows(const mc5::Program& program, const project::Project& project,
               const ProjectFolder& folder) {
  const auto heads = headLines(project.sources);
  Json list = Json::array();
  for (const auto& [id, block] : program) {
    const monitor::BlockRow row = monitor::blockRow(block);
    const auto head = heads.find({block.file, id});
    const source::Symbol* const symbol = monitor::findSymbol(row.id, project.symbols);
    list.push_back({{"id", toString(row.id)},
                    {"symbol", symbol == nullptr ? row.symbol : symbol->name},
                    {"title", titleOf(block)},
                    {"language", id.type == mc5::BlockType::Db ? "DB" : "AWL"},
                    {"load", 2 * row.load},
                    {"work", 2 * row.work},
                    {"file", folder.relative(block.file)},
                    {"line", head == heads.end() ? 0 : head->second},
                    {"calls", callsOf(block)},
                    {"version", ""},
                    {"checksum", ""}});
  }
  return list;
}

Json interfaceRows(const block::Program& program, const std::map<BlockId, BlockSource>& sources,
                   const ProjectFolder& folder) {
  Json list = Json::array();
  for (const auto& [id, source] : sources) {
    const auto block = program.find(id);
    if (block == program.end() || block->second.variables.empty()) continue;
    Json variables = Json::array();
    for (const block::Variable& variable : block->second.variables)
      variables.push_back(
          {{"name", variable.name},
           {"address", fmt::format("{}.{}", variable.address / 8, variable.address % 8)}});
    list.push_back({{"block", toString(id)},
                    {"file", folder.relative(source.file)},
                    {"line", source.line},
                    {"variables", std::move(variables)}});
  }
  return list;
}

namespace {

std::string textOf(BlockId id) { return toString(id); }
std::string textOf(mc5::BlockId id) { return toString(mc5::neutralId(id)); }

// Of either family: a block stands under its id.
template <class Program>
Json compared(const Program& offline, const Program& online) {
  Json list = Json::array();
  for (const auto& [id, block] : offline) {
    if (!isLoaded(id)) continue;
    const auto other = online.find(id);
    const bool there = other != online.end();
    const std::string where = there ? difference(block, other->second) : "";
    list.push_back({{"id", textOf(id)},
                    {"state", !there          ? "onlyOffline"
                              : where.empty() ? "same"
                                              : "different"},
                    {"where", where}});
  }
  for (const auto& [id, block] : online)
    if (isLoaded(id) && !offline.contains(id))
      list.push_back({{"id", textOf(id)}, {"state", "onlyOnline"}, {"where", ""}});
  return list;
}

}  // namespace

Json comparison(const block::Program& offline, const block::Program& online) {
  return compared(offline, online);
}

Json comparison(const mc5::Program& offline, const mc5::Program& online) {
  return compared(offline, online);
}

Json referenceRows(const std::vector<monitor::CrossReference>& list, const ProjectFolder& folder) {
  Json rows = Json::array();
  for (const monitor::CrossReference& row : list)
    rows.push_back({{"operand", row.operand},
                    {"symbol", row.symbol},
                    {"block", toString(row.place.block)},
                    {"file", folder.relative(row.place.file)},
                    {"line", row.place.line},
                    {"network", row.place.network},
                    {"instruction", row.instruction},
                    {"access", row.use == monitor::Use::Call ? "CALL" : monitor::name(row.use)}});
  return rows;
}

std::string codeText(const block::Block& block, Mnemonics mnemonics) {
  if (block.code.empty()) return dataText(block);
  std::string text;
  for (const mc7::Line& line : mc7::disassemble(block.code, mnemonics))
    text += mc7::toString(line) + "\n";
  return text;
}

std::string codeText(const mc5::Block& block) {
  std::string text;
  if (block.id.type == mc5::BlockType::Db) {
    for (std::size_t i = 0; i < block.words.size(); ++i)
      text += fmt::format("DW {:<5} {:04X}\n", i, block.words[i]);
    return text;
  }
  for (const mc5::Line& line : mc5::disassemble(block.words)) text += mc5::toString(line) + "\n";
  return text;
}

std::string listing(const monitor::BlockCode& code, Mnemonics mnemonics) {
  return code.s7() != nullptr ? codeText(*code.s7(), mnemonics) : codeText(*code.s5());
}

// Where its END_ stands.
static std::uint32_t lastLine(const BlockSource& source) {
  const auto lines = static_cast<std::uint32_t>(std::ranges::count(source.text, '\n'));
  return source.line + std::max(lines, 1u) - 1;
}

// The longest block has 32,768 instructions.
Json machineCodeRows(const monitor::BlockCode& code, Mnemonics mnemonics, const BlockSource* source,
                     const ProjectFolder& folder) {
  auto list = monitor::machineCode(code, mnemonics);
  // The BE that ends the block without a statement: its END_ is what it was made of.
  if (source != nullptr && !list.empty() && list.back().line == 0 && list.front().line != 0)
    list.back().line = lastLine(*source);
  Json rows = Json::array();
  for (monitor::MachineCodeRow& row : list)
    rows.push_back({{"offset", row.offset},
                    {"code", std::move(row.code)},
                    {"text", std::move(row.text)},
                    {"line", row.line},
                    {"initial", std::move(row.initial)},
                    {"value", std::move(row.value)}});
  return Json{{"block", toString(code.id())},
              {"file", folder.relative(code.file())},
              {"unit", monitor::name(code.unit())},
              {"rows", std::move(rows)}};
}

}  // namespace merker::workbench
