#include "s7p/sources.h"

#include "s7p/dbase.h"

namespace merker::s7p {

constexpr std::uint32_t kAwl = 1122309;
constexpr std::size_t kMostSources = 20'000;

std::vector<SourceRow> readSources(const archive::Tree& tree, const std::string& folder,
                                   const CodePage& page, Faults& faults) {
  Table table = openTable(tree, folder + "/s7contai.dbf", faults);
  std::vector<SourceRow> rows;
  while (table.next()) {
    if (rows.size() == kMostSources) {
      faults.push_back(
          {FaultKind::LongTable, folder + "/S7CONTAI.DBF", std::to_string(kMostSources)});
      break;
    }
    const std::string file(archive::nameOf(archive::folded(table.text("FILENAME"))));
    const auto* entry = file.empty() ? nullptr : tree.find(folder + "/" + file);
    rows.push_back({page.toUtf8(table.text("NAME")), entry ? entry->path : std::string(),
                    table.numberOr("TYPE", 0) == kAwl});
  }
  return rows;
}

}  // namespace merker::s7p
