// Device manuals "CPU 31xC and CPU 31x" (2004) and "CPU 312 IFM to CPU 318-2 DP", technical data,
// "number of connections"; the course has the 12 of the 314C.
#include "catalogue/communication.h"

#include <algorithm>
#include <iterator>

namespace merker {
namespace {

struct ConnectionRow {
  std::string_view keyword;
  ConnectionLimits limits;
};

constexpr ConnectionRow kConnections[] = {
    {"312C", {6, 2}},          {"313C", {8, 4}},        {"313C-2 PtP", {8, 4}},
    {"313C-2 DP", {8, 4}},     {"314C-2 PtP", {12, 8}}, {"314C-2 DP", {12, 8}},
    {"314C-2 PN/DP", {12, 8}}, {"312 IFM", {4, 2}},     {"318-2", {32, 30}},
    {"generic", {64, 62}},     {"generic-4", {64, 62}},
};

}  // namespace

ConnectionLimits connectionLimits(const CpuModel& model) {
  const auto* const row = std::ranges::find(kConnections, model.keyword, &ConnectionRow::keyword);
  return row == std::end(kConnections) ? ConnectionLimits{} : row->limits;
}

}  // namespace merker
