// [[station]]: another station; of a station itself the one that X27 is connected to (PTP-LINE-03).
#include <fmt/format.h>

#include "base/text.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::size_t kLongestName = 32;

// It stands in front of operands: Press/E 0.0.
bool isName(std::string_view name) {
  constexpr std::string_view kCharacters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  return !name.empty() && name.size() <= kLongestName &&
         name.find_first_not_of(kCharacters) == std::string_view::npos;
}

}  // namespace

std::optional<OtherStation> readStation(const Table& table) {
  table.allow({"name", "folder"});
  OtherStation other;
  for (const auto& [key, target] : {std::pair{"name", &other.name}, {"folder", &other.folder}}) {
    const auto text = table.text(key, "a text");
    if (!table.has(key))
      table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                           "name = \"Press\" and folder = \"press\"");
    if (!text) return std::nullopt;
    *target = *text;
  }
  other.named = table.at("folder");
  if (isName(other.name)) return other;
  table.mustBe("name", fmt::format("at most {} letters, digits, '-' and '_'", kLongestName));
  return std::nullopt;
}

std::vector<OtherStation> readStations(const Table& root,
                                       const std::optional<serial::Connection>& serial) {
  const bool wanted = serial && serial->kind == serial::Connection::Kind::Station;
  const auto connected = [&](const OtherStation& other) {
    return wanted && equalsIgnoreCase(serial->place, other.name);
  };
  std::vector<OtherStation> others;
  bool complete = true;
  for (const Table& table : root.tables("station")) {
    auto other = readStation(table);
    complete &= other.has_value();
    if (!other) continue;
    if (!connected(*other) || !others.empty())
      table.mustBe("name",
                   "one station that X27 is connected to: [serial] X27 = \"station:" + other->name +
                       "\"; a project of several stations has no [cpu], [program], "
                       "[hardware] of its own");
    else
      others.push_back(std::move(*other));
  }
  if (wanted && complete && others.empty())
    root.table("serial")->mustBe("X27", "\"station:NAME\" with the name of a [[station]]");
  return others;
}

}  // namespace merker::project
