// What stands in front of the end of a wire: a station, a plant; and what is wrong with it.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "project/plant_reader.h"

namespace merker::project {
namespace {

// "1" of "1/4.DI0", "DP4" and "AS4" of "DP4/1.DI0", "AS4/1.DI0": no name of a station.
bool isPlace(std::string_view name) {
  if (equalsIgnoreCase(name.substr(0, 2), "DP") || equalsIgnoreCase(name.substr(0, 2), "AS"))
    name.remove_prefix(2);
  return !name.empty() && name.find_first_not_of("0123456789") == std::string_view::npos;
}

// The text in front of a slash; empty: there is none. A name of a module in quotation marks may
// have one in it.
std::string_view beforeSlash(std::string_view end) {
  const auto slash = end.find('/');
  return slash == std::string_view::npos || end.find('"') < slash ? std::string_view{}
                                                                  : trim(end.substr(0, slash));
}

}  // namespace

// "Press/E 0.0": the station in front of the end, which is taken off.
std::optional<std::size_t> PlantReader::otherStation(std::string_view& end) const {
  const std::string_view name = beforeSlash(end);
  if (stations_ == nullptr || name.empty()) return std::nullopt;
  for (std::size_t i = 0; i < stations_->size(); ++i) {
    if (!equalsIgnoreCase((*stations_)[i].name, name)) continue;
    end = trim(end.substr(end.find('/') + 1));
    return i;
  }
  return std::nullopt;
}

// "Pres/E 0.0" where no station is called so, or this one has no others; then it is a problem.
bool PlantReader::isStrange(const Asked& asked, std::string_view end) const {
  const std::string_view name = beforeSlash(end);
  if (name.empty() || isPlace(name) || rack_.module(end.substr(0, end.rfind('.')))) return false;
  asked.table.mustBe(
      asked.key,
      stations_ == nullptr
          ? fmt::format("a terminal of this station; a plant with a wire to another one, {}, "
                        "stands in the merker.toml of the project that names the stations",
                        name)
          : fmt::format("a terminal of a station: {}; there is no station {}", namesOf(*stations_),
                        name));
  return true;
}

bool PlantReader::isNamed(std::size_t station, std::string_view plant) const {
  return expected_ != nullptr && (*expected_)[station].contains(upper(plant));
}

// Whether `front`, of "PLANT.SIGNAL", is a plant of this station that cannot feed this one; then it
// is a problem, unless that plant is one already.
bool PlantReader::cannotFeed(const Asked& asked, std::string_view front,
                             const plant::Wire& wire) const {
  if (refused_.contains(upper(front))) return true;
  Problems& problems = asked.table.problems();
  if (equalsIgnoreCase(front, asked.plant.name))
    problems.add(ProblemCode::P0764, asked.table.at(asked.key), titleOf(asked.signal), wire.text,
                 "a plant cannot feed itself");
  else if (isNamed(own_, front))
    problems.add(ProblemCode::P0767, asked.table.at(asked.key), front);
  else
    return false;
  return true;
}

// Whether it is one of another station, of `station` if the text names it; then it is a problem.
bool PlantReader::isOfOthers(const Asked& asked, std::optional<std::size_t> station,
                             std::string_view front, const plant::Wire& wire) const {
  if (stations_ == nullptr) return false;
  for (std::size_t i = 0; i < stations_->size(); ++i) {
    const StationField& one = (*stations_)[i];
    if (i == own_ || (station && *station != i)) continue;
    if (!isNamed(i, front) && (one.plants == nullptr || !one.plants->find(front))) continue;
    asked.table.problems().add(
        ProblemCode::P0764, asked.table.at(asked.key), titleOf(asked.signal), wire.text,
        fmt::format("that is a plant of the station {}; plants feed only those of their own "
                    "station",
                    one.name));
    return true;
  }
  return false;
}

}  // namespace merker::project
