// What `merker network` shows of a project of several stations.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compilation/network_plan.h"

namespace merker::app {

using compilation::NetworkPlan;
using compilation::PlannedConnection;
using compilation::PlannedNode;
using compilation::PlannedStation;
using compilation::PlannedSubnet;

// "every 8 cycles: Press/MB 100:8 → Belt/MB 200"
std::string circleText(const project::GlobalDataRow& row);
std::string toText(const NetworkPlan& plan);
nlohmann::ordered_json toJson(const NetworkPlan& plan);
// As NetPro draws it: stations as boxes, subnets as lines in their colours.
std::string toSvg(const NetworkPlan& plan);

}  // namespace merker::app
