#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "source/symbol_table.h"

namespace merker::source {
namespace {

SymbolTable sample() {
  SymbolTable table;
  Problems problems;
  const SourceFile file(
      "a.sym",
      "Motor A 1.0 BOOL // treibt das \"Band\"\n\"Größe 1\" MW 10 INT\nAchse DB 11 FB 3\n"
      "Uhr MD 20 TOD\nTakt T 5\n");
  readSymbols(file, table, problems);
  EXPECT_TRUE(problems.empty());
  return table;
}

TEST(WriteSymbols, readableTable) {
  EXPECT_EQ(writeSymbols(sample(), ".sym", Mnemonics::International),
            "\"Motor\"    Q 1.0       BOOL        // treibt das \"Band\"\n"
            "\"Größe 1\"  MW 10       INT\n"
            "\"Achse\"    DB 11       FB 3\n"
            "\"Uhr\"      MD 20       TIME_OF_DAY\n"
            "\"Takt\"     T 5         TIMER\n");
}

TEST(WriteSymbols, columnsOfStep7) {
  const std::string text = writeSymbols(sample(), ".asc", Mnemonics::German);
  EXPECT_EQ(text.substr(0, 132),
            "126,Motor                   A       1.0 BOOL      treibt das \"Band\"" +
                std::string(63, ' ') + "\r\n");
  EXPECT_EQ(text.size(), 5 * 132u);
  EXPECT_EQ(text.substr(132, 50),
            "126,Gr\xF6\xDF"
            "e 1                 MW     10   INT       ");
  EXPECT_EQ(text.substr(3 * 132, 46), "126,Uhr                     MD     20   TOD   ");
}

TEST(WriteSymbols, otherExtensionsGiveNothing) {
  EXPECT_EQ(writeSymbols(sample(), ".csv", Mnemonics::German), "");
}

std::string letters() {
  return *rc::gen::container<std::string>(
      rc::gen::element('a', 'B', '7', '_', ' ', ',', ';', '/', '-', '\''));
}

SymbolAddress randomAddress(std::uint16_t i) {
  static const std::vector<std::string> kOperands = {"E %.3", "AB %",  "MW %", "MD %", "PEW %",
                                                     "PAD %", "T %",   "Z %",  "DB %", "FC %",
                                                     "SFB %", "UDT %", "VAT %"};
  std::string text = *rc::gen::elementOf(kOperands);
  text.replace(text.find('%'), 1, std::to_string(i));
  return *parseSymbolAddress(text, {});
}

SymbolTable randomTable() {
  SymbolTable table;
  const int count = *rc::gen::inRange(0, 20);
  for (std::uint16_t i = 0; i < count; ++i) {
    Symbol symbol;
    symbol.name = "ü" + letters().substr(0, 10) + std::to_string(i);
    symbol.address = randomAddress(i);
    symbol.type = TypeCode::Void;
    symbol.comment = *rc::gen::arbitrary<bool>() ? "\"" + letters().substr(0, 70) + "ß\"" : "";
    if (symbol.address.kind == SymbolAddress::Kind::Timer) symbol.type = TypeCode::Timer;
    if (symbol.address.kind == SymbolAddress::Kind::Counter) symbol.type = TypeCode::Counter;
    if (symbol.address.kind == SymbolAddress::Kind::Memory) {
      constexpr TypeCode kTypes[] = {TypeCode::Bool, TypeCode::Char, TypeCode::S5Time,
                                     TypeCode::TimeOfDay};
      symbol.type = kTypes[static_cast<int>(symbol.address.width)];
    }
    if (symbol.address.block.kind == BlockKind::DB)
      symbol.blockType = BlockId{BlockKind::FB, 65535};
    table.add(symbol);
  }
  return table;
}

// S7-SYM-17: writing and reading gives the same table; .seq has no types.
RC_GTEST_PROP(WriteSymbols, readingGivesTheSameTable, ()) {
  const SymbolTable table = randomTable();
  const std::string extension =
      *rc::gen::elementOf(std::vector<std::string>{".sdf", ".asc", ".seq", ".dif", ".sym"});
  const auto mnemonics = *rc::gen::element(Mnemonics::German, Mnemonics::International);
  const std::string bytes = writeSymbols(table, extension, mnemonics);
  const auto encoding = extension == ".sym" ? Encoding::Utf8 : Encoding::Cp1252;

  SymbolTable again;
  Problems problems;
  readSymbols(SourceFile("a" + extension, toUtf8(bytes, encoding)), again, problems);
  if (table.list().empty() && extension != ".dif") RC_SUCCEED("nothing to read");
  RC_ASSERT(problems.empty());
  RC_ASSERT(again.list().size() == table.list().size());
  for (std::size_t i = 0; i < table.list().size(); ++i) {
    const Symbol &a = table.list()[i], &b = again.list()[i];
    RC_ASSERT(a.name == b.name);
    RC_ASSERT(a.address == b.address);
    RC_ASSERT(a.comment == b.comment);
    RC_ASSERT(extension == ".seq" || a.type == b.type);
    RC_ASSERT(extension == ".seq" || a.blockType == b.blockType);
  }
}

}  // namespace
}  // namespace merker::source
