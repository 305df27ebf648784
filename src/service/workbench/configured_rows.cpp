#include "workbench/configured_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "compilation/network_plan.h"
#include "workbench/shared.h"

namespace merker::workbench {
namespace {

using compilation::PlannedConnection;

// "closed": no server carries it.
std::string stateOf(const PlannedConnection& one, const S7Outside& outside) {
  if (one.inside) return "inside";
  if (one.kind == ConnectionKind::S7) {
    const auto row =
        std::ranges::find(outside.partners, fmt::format("W#16#{:X}", one.id), &S7PartnerRow::id);
    return row == outside.partners.end() ? "closed" : row->state;
  }
  const auto row = std::ranges::find(outside.ofCp, one.id, &CpConnectionRow::id);
  if (row == outside.ofCp.end()) return "closed";
  return row->connected ? "connected" : one.active ? "calls" : "waits";
}

}  // namespace

Json configuredRows(const Shared& shared, const S7Outside& outside) {
  Json rows = Json::array();
  if (!shared.plc) return rows;
  const compilation::NetworkPlan plan =
      shared.lab ? planOf(shared.lab->build) : planOf(shared.plc->build());
  const auto isShown = [&](const PlannedConnection& one) {
    return !shared.lab || plan.stations[one.station].name == shared.stationName();
  };
  for (const PlannedConnection& one : plan.connections)
    if (isShown(one))
      rows.push_back({{"kind", compilation::kindName(one.kind)},
                      {"id", one.id},
                      {"partner", one.partner},
                      {"active", one.active},
                      {"state", stateOf(one, outside)}});
  return rows;
}

}  // namespace merker::workbench
