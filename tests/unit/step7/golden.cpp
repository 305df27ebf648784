#include "golden.h"

#include <gtest/gtest.h>

#include "base/bytes.h"
#include "mc7/disassembly.h"

namespace merker::step7 {
namespace {

std::string withSingleBlanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' || (!out.empty() && out.back() != ' ')) out += c;
  return out;
}

// The bytes of one line of a listing.
std::vector<std::uint8_t> assembled(const mc7::Line& line) {
  const std::string text = withSingleBlanks(line.text);
  std::vector<std::uint8_t> code;
  if (const auto entry = parseListEntry(text, {})) {
    if (*entry) appendDWord(code, entry->value());
    return code;
  }
  const auto instruction = parseInstruction(text, {}, Mnemonics::German);
  EXPECT_TRUE(instruction && mc7::encode(instruction.value(), code)) << text;
  return code;
}

struct Shape {
  const char *begin, *end;
};

Shape shapeOf(BlockKind kind) {
  if (kind == BlockKind::FC) return {"FUNCTION FC 9 : VOID\n", "END_FUNCTION\n"};
  if (kind == BlockKind::FB) return {"FUNCTION_BLOCK FB 9\n", "END_FUNCTION_BLOCK\n"};
  return {"ORGANIZATION_BLOCK OB 1\n", "END_ORGANIZATION_BLOCK\n"};
}

}  // namespace

std::string codeOf(const Compiled& compiled, BlockKind kind, int number) {
  std::string text;
  for (const mc7::Line& line :
       mc7::disassemble(compiled.block(kind, number).code, Mnemonics::German)) {
    EXPECT_EQ(assembled(line), std::vector<std::uint8_t>(line.bytes.begin(), line.bytes.end()))
        << line.text;
    text += (text.empty() ? "" : "; ") + withSingleBlanks(line.text);
  }
  return text;
}

std::string compiledIn(BlockKind kind, const Golden& row, std::string_view others) {
  const Shape shape = shapeOf(kind);
  const Compiled compiled = compileText(std::string(others) + shape.begin + row.declarations +
                                            "\nBEGIN\n" + row.statements + "\n" + shape.end,
                                        "generic");
  EXPECT_FALSE(compiled.result.problems.hasErrors())
      << row.statements << ": " << (compiled.problems().empty() ? "" : compiled.problems().front());
  return codeOf(compiled, kind, kind == BlockKind::OB ? 1 : 9);
}

void expectCode(BlockKind kind, std::span<const Golden> rows, std::string_view others) {
  for (const Golden& row : rows)
    EXPECT_EQ(compiledIn(kind, row, others), row.code) << row.declarations << row.statements;
}

}  // namespace merker::step7
