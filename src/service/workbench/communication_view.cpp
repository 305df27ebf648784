#include "workbench/communication_view.h"

namespace merker::workbench {
namespace {

Json clientJson(const S7ClientRow& row) {
  return {{"partner", row.partner}, {"kind", row.kind},         {"pdu", row.pdu},
          {"seconds", row.seconds}, {"requests", row.requests}, {"received", row.received},
          {"sent", row.sent},       {"lost", row.lost}};
}

Json partnerJson(const S7PartnerRow& row) {
  return {{"id", row.id},         {"host", row.host},   {"port", row.port},
          {"active", row.active}, {"state", row.state}, {"pdu", row.pdu}};
}

Json refusalJson(const S7RefusedRow& row) {
  return {
      {"partner", row.partner}, {"why", row.why}, {"times", row.times}, {"seconds", row.seconds}};
}

template <typename Rows, typename Write>
Json listOf(const Rows& rows, Write write) {
  Json list = Json::array();
  for (const auto& row : rows) list.push_back(write(row));
  return list;
}

}  // namespace

Json s7Json(const S7Outside& outside) {
  return {{"place", outside.place},
          {"beyond", !outside.warning.empty()},
          {"connections", outside.connections ? Json(*outside.connections) : Json(nullptr)},
          {"pg", outside.pg},
          {"op", outside.op},
          {"basic", outside.basic},
          {"confirmed", outside.confirmed},
          {"refused", outside.refused},
          {"broken", outside.broken},
          {"requests", outside.requests},
          {"denied", outside.denied},
          {"clients", listOf(outside.clients, clientJson)},
          {"partners", listOf(outside.partners, partnerJson)},
          {"refusals", listOf(outside.refusals, refusalJson)}};
}

}  // namespace merker::workbench
