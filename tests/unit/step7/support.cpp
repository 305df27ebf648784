#include "support.h"

#include <gtest/gtest.h>

#include "mc7/disassembly.h"

namespace merker::step7 {
namespace {

// SFC 46 without parameters, SFB 4 (TON) and FC 99 (BITSUM), as the library of a CPU would list
// them.
const block::Program& library() {
  static const block::Program program = [] {
    block::Program blocks;
    block::Block stop, timer, bits;
    bits.id = {BlockKind::FC, 99};
    block::Variable word;
    word.name = "IN";
    word.section = block::Section::Input;
    word.type = block::elementaryType(TypeCode::DWord);
    bits.variables.push_back(word);
    blocks.emplace(bits.id, bits);
    stop.id = {BlockKind::SFC, 46};
    blocks.emplace(stop.id, stop);
    timer.id = {BlockKind::SFB, 4};
    const auto add = [&timer](const char* name, block::Section section, TypeCode type) {
      block::Variable variable;
      variable.name = name;
      variable.section = section;
      variable.type = block::elementaryType(type);
      timer.variables.push_back(std::move(variable));
    };
    add("IN", block::Section::Input, TypeCode::Bool);
    add("PT", block::Section::Input, TypeCode::Time);
    add("Q", block::Section::Output, TypeCode::Bool);
    add("ET", block::Section::Output, TypeCode::Time);
    timer.instanceBytes = block::layOut(timer.variables, 0, true) / 8;
    blocks.emplace(timer.id, timer);
    return blocks;
  }();
  return program;
}

}  // namespace

Compiled compileText(std::string_view text, std::string_view model, bool checks,
                     const source::SymbolTable* symbols) {
  CompileOptions options;
  options.model = findCpuModel(model);
  options.library = &library();
  options.checks = checks;
  options.symbols = symbols;
  return {compile({source::SourceFile("test.awl", std::string(text))}, options)};
}

std::vector<std::string> Compiled::problems() const {
  std::vector<std::string> list;
  for (const Problem& problem : result.problems.list())
    list.push_back(
        fmt::format("{}:{} {}", problem.position.line, problem.position.column, problem.name()));
  return list;
}

const block::Block& Compiled::block(BlockKind kind, int number) const {
  static const block::Block none;
  const auto found = result.program.find({kind, static_cast<std::uint16_t>(number)});
  EXPECT_NE(found, result.program.end());
  return found == result.program.end() ? none : found->second;
}

std::string Compiled::listing(BlockKind kind, int number) const {
  std::string text;
  for (const mc7::Line& line : mc7::disassemble(block(kind, number).code, Mnemonics::German))
    text += line.text + "\n";
  return text;
}

static std::string dataBlock(int number) {
  return fmt::format("DATA_BLOCK DB {}\nSTRUCT\nx : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n",
                     number);
}

std::string statements(std::string_view code, std::string_view model) {
  const Compiled compiled =
      compileText("ORGANIZATION_BLOCK OB 1\nBEGIN\n" + std::string(code) +
                      "\nEND_ORGANIZATION_BLOCK\n" + dataBlock(5) + dataBlock(6),
                  model);
  EXPECT_EQ(compiled.problems(), std::vector<std::string>{}) << code;
  std::string text = compiled.listing(BlockKind::OB, 1);
  if (text.ends_with("BE\n")) text.resize(text.size() - 3);
  return text;
}

}  // namespace merker::step7
