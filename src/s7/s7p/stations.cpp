#include "s7p/stations.h"

#include "s7p/catalogue.h"
#include "s7p/dbase.h"

namespace merker::s7p {
namespace {

constexpr std::uint32_t kS7300 = 1314969;  // type of a station
constexpr std::size_t kMostObjects = 100'000;
constexpr int kDeepest = 16;

}  // namespace

Stations::Stations(const archive::Tree& tree, const std::string& project, const CodePage& page) {
  for (const auto& entry : tree.below(under(project, "homsave7"))) {
    if (archive::folded(archive::nameOf(entry.path)) != "hobject1.dbf") continue;
    Table table(tree.open(entry));
    while (table.next() && objects_.size() < kMostObjects) {
      Object object{table.numberOr("UNITTYP", 0), table.numberOr("UNITID", 0),
                    page.toUtf8(table.text("NAME"))};
      objects_.try_emplace({table.numberOr("OBJTYP", 0), table.numberOr("ID", 0)},
                           std::move(object));
    }
  }
}

void Stations::fill(std::uint32_t type, std::uint32_t id, Program& program) const {
  auto at = objects_.find({type, id});
  if (at != objects_.end()) program.cpu = at->second.name;
  for (int depth = 0; at != objects_.end() && depth < kDeepest; ++depth) {
    if (at->first.first == kS7300) program.station = at->second.name;
    at = objects_.find({at->second.parentType, at->second.parent});
  }
}

}  // namespace merker::s7p
