#include "importing/symbol_rows.h"

#include "base/text.h"

namespace merker::importing {
namespace {

std::string oneLine(std::string_view text) {
  std::string out(trim(text));
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == '"') c = c == '"' ? '\'' : ' ';
  return out;
}

std::string lineOf(const s7p::SymbolRow& row, bool type) {
  return fmt::format("\"{}\" {} {} // {}\n", oneLine(row.name), oneLine(row.address),
                     type ? oneLine(row.type) : "", oneLine(row.comment));
}

}  // namespace

source::SymbolTable tableOf(const std::vector<s7p::SymbolRow>& rows, Report& report) {
  source::SymbolTable table;
  for (const s7p::SymbolRow& row : rows) {
    // With the type first; one that does not fit costs itself only.
    for (const bool type : {true, false}) {
      Problems problems;
      const source::SourceFile file("symbols.sym", lineOf(row, type));
      source::SymbolTable one;
      source::readSymbols(file, one, problems);
      if (!problems.hasErrors() && one.list().size() == 1) {
        source::Symbol symbol = one.list().front();
        symbol.position = {};
        if (!table.add(std::move(symbol)))
          report.add(Note::WrongSymbol, row.name, "the name exists already");
        break;
      }
      if (!type)
        report.add(Note::WrongSymbol, row.name,
                   problems.empty() ? row.address : problems.list().front().message);
    }
  }
  return table;
}

}  // namespace merker::importing
