#include "s7p/symbols.h"

#include "s7p/dbase.h"

namespace merker::s7p {
namespace {

constexpr std::size_t kMostSymbols = 200'000;

// "PEW   370" to "PEW 370".
std::string withSingleBlanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' || (!out.empty() && out.back() != ' ')) out.push_back(c);
  return out;
}

}  // namespace

std::vector<SymbolRow> readSymbols(const archive::Tree& tree, const std::string& folder,
                                   const CodePage& page, Faults& faults) {
  Table table = openTable(tree, folder + "/symlist.dbf", faults);
  std::vector<SymbolRow> rows;
  while (table.next()) {
    if (rows.size() == kMostSymbols) {
      faults.push_back(
          {FaultKind::LongTable, folder + "/SYMLIST.DBF", std::to_string(kMostSymbols)});
      break;
    }
    SymbolRow row{page.toUtf8(table.text("_SKZ")), withSingleBlanks(table.text("_OPHIST")),
                  withSingleBlanks(table.text("_DATATYP")), page.toUtf8(table.text("_COMMENT"))};
    if (row.address.empty()) row.address = withSingleBlanks(table.text("_OPIEC"));
    if (!row.name.empty() && !row.address.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace merker::s7p
