#include "workbench/symbol_rows.h"

#include <algorithm>
#include <array>

#include "base/text.h"
#include "source/symbol_text.h"

namespace merker::workbench {
namespace {

// One line of a .sym file for each row, so that a problem's line is its row.
struct Line {
  std::string text;
  std::array<std::uint32_t, 4> columns{};  // where the fields begin
};

// Characters, not bytes: as columns count.
std::uint32_t length(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

// A line break or quotation mark in a field would begin another one.
std::string oneLine(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

Line lineOf(const SymbolRow& row) {
  Line line;
  const std::string parts[] = {fmt::format("\"{}\"", oneLine(row.symbol)), oneLine(row.operand),
                               oneLine(row.type), oneLine(row.comment)};
  for (std::size_t i = 0; i < 4; ++i) {
    if (i == 3 && !trim(row.comment).empty()) line.text += "// ";
    line.columns[i] = length(line.text) + 1;
    line.text += parts[i] + (i < 3 ? "  " : "");
  }
  return line;
}

// What a line of a file cannot say any more: a name that ends it, or a field that is not there.
std::optional<RowProblem> missing(const SymbolRow& row, std::size_t number) {
  const Position at{"", static_cast<std::uint32_t>(number + 1), 0, 0};
  if (row.symbol.find('"') != std::string::npos)
    return RowProblem{number, "symbol", makeProblem(ProblemCode::P0809, at, row.symbol)};
  if (!trim(row.symbol).empty() && trim(row.operand).empty())
    return RowProblem{number, "operand", makeProblem(ProblemCode::P0812, at, row.symbol)};
  return std::nullopt;
}

constexpr std::string_view kFields[] = {"symbol", "operand", "type", "comment"};

std::string_view fieldAt(const Line& line, std::uint32_t column) {
  std::size_t field = 0;
  while (field < 3 && line.columns[field + 1] <= column) ++field;
  return kFields[field];
}

}  // namespace

SymbolRow symbolRow(const source::Symbol& symbol, source::Language language) {
  const std::string number = source::operandNumber(symbol.address);
  return {symbol.name,
          fmt::format("{} {}", source::operandName(symbol.address, Mnemonics::German, language),
                      number),
          source::typeText(symbol), symbol.comment};
}

Json toJson(const SymbolRow& row) {
  return {{"symbol", row.symbol},
          {"operand", row.operand},
          {"type", row.type},
          {"comment", row.comment}};
}

bool CheckedRows::good() const {
  return std::ranges::none_of(
      problems, [](const RowProblem& one) { return one.problem.severity() == Severity::Error; });
}

CheckedRows checkRows(const std::vector<SymbolRow>& rows, source::Language language) {
  CheckedRows result;
  result.table = source::SymbolTable(language);
  std::string text;
  std::vector<Line> lines;
  for (const SymbolRow& row : rows) {
    const auto problem = missing(row, lines.size());
    if (problem) result.problems.push_back(*problem);
    lines.push_back(problem ? Line() : lineOf(row));
    text += lines.back().text + "\n";
  }
  Problems problems;
  source::readSymbols(source::SourceFile("symbols.sym", text), result.table, problems);
  for (const Problem& problem : problems.list()) {
    const std::size_t row = problem.position.line == 0 ? 0 : problem.position.line - 1;
    if (row < lines.size())
      result.problems.push_back({row, fieldAt(lines[row], problem.position.column), problem});
  }
  return result;
}

Json toJson(const std::vector<RowProblem>& problems) {
  Json list = Json::array();
  for (const RowProblem& one : problems) {
    Json json = toJson(one.problem);
    json["file"] = "";
    json["row"] = one.row;
    json["field"] = one.field;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace merker::workbench
