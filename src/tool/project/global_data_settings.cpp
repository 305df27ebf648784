// [[global_data]] of a project of several stations (S7-NET-27).
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::uint32_t kMostCircles = 16, kHighestRate = 255;

std::vector<GlobalDataRow::Place> readPlaces(const Table& table, std::string_view key) {
  std::vector<GlobalDataRow::Place> places;
  const auto texts = table.texts(key, "a list of operands: [\"Belt/MB 200\"]");
  if (!texts) return places;
  for (const Table::Text& text : *texts) places.push_back({text.text, text.position});
  return places;
}

}  // namespace

void readGlobalData(const Table& root, Network& network) {
  for (const Table& table : root.tables("global_data")) {
    table.allow({"circle", "from", "to", "rate", "status", "group_status"});
    for (const char* key : {"circle", "from", "to"})
      if (!table.has(key))
        table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                             "circle = 1, from = \"Press/MB 100:8\" and to = [\"Belt/MB 200\"]");
    GlobalDataRow row;
    const auto circle = table.number("circle", 1, kMostCircles);
    const auto from = table.text("from", "an operand: \"Press/MB 100:8\"");
    row.circleAt = table.at("circle");
    row.rate = table.number("rate", 1, kHighestRate).value_or(row.rate);
    row.to = readPlaces(table, "to");
    if (const toml::array* const list = table.has("to") ? table.node("to")->as_array() : nullptr;
        list != nullptr && list->empty())
      table.mustBe("to", "at least one operand: [\"Belt/MB 200\"]");
    row.status = readPlaces(table, "status");
    row.groupStatus = readPlaces(table, "group_status");
    if (!circle || !from || row.to.empty()) continue;
    row.circle = *circle;
    row.from = {*from, table.at("from")};
    network.globalData.push_back(std::move(row));
  }
}

}  // namespace merker::project
