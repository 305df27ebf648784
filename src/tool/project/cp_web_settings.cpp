// web = { … } in the [[module]] of a CP 343-1 IT: its web server (S7-NET-16).
#include <fmt/format.h>

#include "catalogue/ethernet.h"
#include "project/files.h"
#include "project/readers.h"

namespace merker::project {
namespace {

// What is served to others lies in the project.
bool isBelow(std::string_view folder) {
  return !folder.empty() && !folder.starts_with('/') && folder.find("..") == folder.npos &&
         folder.find('\\') == folder.npos;
}

void readPages(const Table& table, CpWebParameters& web) {
  constexpr std::string_view kWhat = "a folder of this project, in which HTML pages lie";
  const auto name = table.text("pages", kWhat);
  if (!name) return;
  web.folder = join(folderOf(table.place().file), *name);
  if (!isBelow(*name) || !isFolder(web.folder)) table.mustBe("pages", kWhat);
}

}  // namespace

void readCpWeb(const Table& table, io::Module& module) {
  if (!table.has("web")) return;
  if (!isItCp(*module.type)) {
    table.problems().add(ProblemCode::P0735, table.placeOf("web"), module.title(),
                         "web server; a CP 343-1 IT has one");
    return;
  }
  const auto web = table.table("web");
  if (!web) return;
  web->allow({"port", "pages"});
  constexpr std::uint32_t kFirst = 1, kLast = 65'535;
  CpWebParameters parameters{.slot = module.slotText()};
  const auto port = web->number("port", kFirst, kLast);
  if (!port && !web->has("port")) web->mustBe("port", "the port of the web server like 8081");
  parameters.port = static_cast<std::uint16_t>(port.value_or(0));
  readPages(*web, parameters);
  module.web = std::make_shared<const CpWebParameters>(std::move(parameters));
}

}  // namespace merker::project
