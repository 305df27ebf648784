#include "project/station_plants.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/text.h"
#include "project/parse.h"
#include "project/plant_reader.h"

namespace merker::project {

std::string namesOf(const std::vector<StationField>& stations) {
  constexpr std::size_t kShown = 10;
  std::string list;
  for (std::size_t i = 0; i < stations.size() && i < kShown; ++i)
    list += (i == 0 ? "" : ", ") + stations[i].name;
  return stations.size() > kShown ? list + ", …" : list;
}

namespace {

// Nothing, and a problem: it has none.
std::optional<std::size_t> stationOf(const Table& table,
                                     const std::vector<StationField>& stations) {
  if (!table.has("station")) {
    table.problems().add(ProblemCode::P0760, table.place(), "station",
                         "the station that it stands beside: " + namesOf(stations));
    return std::nullopt;
  }
  const auto name = table.text("station", "the name of a [[station]]");
  const auto found = std::ranges::find_if(
      stations, [&](const StationField& one) { return name && equalsIgnoreCase(one.name, *name); });
  if (found == stations.end()) {
    if (name) table.mustBe("station", "the name of a [[station]]: " + namesOf(stations));
    return std::nullopt;
  }
  if (found->hardware != nullptr) return static_cast<std::size_t>(found - stations.begin());
  table.mustBe("station", "a SIMATIC S7; a SINUMERIK has no modules with terminals");
  return std::nullopt;
}

}  // namespace

void readStationPlants(const source::SourceFile& file, std::vector<StationField>& stations,
                       Problems& problems) {
  Problems known;  // its text was read before
  const auto text = parseToml(file, known);
  if (!text) return;
  const Table root(*text, "", Position{file.name(), 1, 1}, problems);
  const std::vector<Table> tables = root.tables("plant");
  std::vector<std::optional<std::size_t>> owners;
  std::vector<std::set<std::string>> names(stations.size());
  std::set<std::string> lost;
  for (const Table& table : tables) {
    owners.push_back(stationOf(table, stations));
    const toml::node* name = table.node("name");
    if (name != nullptr && name->is_string())
      (owners.back() ? names[*owners.back()] : lost).insert(upper(name->as_string()->get()));
  }
  std::map<std::size_t, PlantReader> readers;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (!owners[i]) continue;
    const StationField& own = stations[*owners[i]];
    PlantReader& reader =
        readers.try_emplace(*owners[i], *own.hardware, *own.plants, &stations, *owners[i])
            .first->second;
    reader.expect(names);
    reader.refuse(lost);
    reader.read(tables[i]);
  }
}

}  // namespace merker::project
