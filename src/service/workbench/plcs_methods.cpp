// Several projects on one server: which PLCs there are, and at which one a browser is.
#include "workbench/method.h"
#include "workbench/neighbours.h"

namespace merker::workbench {
namespace plcs_methods {
namespace {

Answer list(const Call& call) {
  return Json{{"here", call.shared.plcNumber},
              {"plcs", call.shared.neighbours ? call.shared.neighbours->rows() : Json::array()}};
}

Answer enter(const Call& call) {
  const auto number = static_cast<std::size_t>(call.fields.integer("plc", 1, kPlcs));
  if (!call.fields.good()) return call.fields.problems();
  if (call.shared.neighbours) call.shared.neighbours->move(call.id, number);
  return empty();
}

constexpr Method kMethods[] = {
    {"plcs.list", Needs::Nothing, list},
    {"plcs.enter", Needs::Nothing, enter},
};

}  // namespace
}  // namespace plcs_methods

std::span<const Method> plcsMethods() { return plcs_methods::kMethods; }

}  // namespace merker::workbench
