// SFC 65 X_SEND, 66 X_RCV, 67 X_GET, 68 X_PUT, 69 X_ABORT: basic communication with another CPU on
// the MPI subnet (S7-SFC-23). SFC 72 I_GET, 73 I_PUT, 74 I_ABORT: the same with a module of the
// station itself; no module here is such a partner.
#include <algorithm>

#include "system/call.h"
#include "system/partner_memory.h"

namespace merker::system {
namespace {

using cpu::Access;

template <typename A>
void answerPartnerJob(A& a, std::uint32_t code) {
  a.set("BUSY", code == basic::kBegun || code == basic::kRuns);
  a.status(code);
}

// What SD or RD names; its error is that of the job.
template <typename A>
Region dataOf(A& a, NameIn<A> parameter, Access access, BasicCommunication::Order& order) {
  const AnyPointer where = a.any(parameter);
  const std::uint32_t bytes = byteCount(where);
  Region region;
  if (bytes > 0 && bytes <= BasicCommunication::kLongest) region = a.region(where, bytes, access);
  if (region.data == nullptr || !region) order.dataError = basic::kBadData;
  return region;
}

template <typename A>
void transfer(A& a, BasicCommunication::Order& order, const Region& region) {
  const std::uint32_t partner = a.value("DEST_ID");
  order.begin = a.flag("REQ");
  order.keep = a.flag("CONT");
  if (partner > BasicCommunication::kHighestAddress)
    return answerPartnerJob(a, order.begin ? basic::kNoAddress : basic::kIdle);
  order.partner = static_cast<std::uint8_t>(partner);
  if (order.kind != MessageKind::Get && order.dataError == 0)
    order.data.assign(region.data, region.data + region.length);
  std::vector<std::uint8_t> answer;
  std::uint32_t code = a.partners().call(order, a.machine().clock, answer);
  if (order.kind == MessageKind::Get && code == 0) {
    if (order.dataError != 0 || answer.size() != region.length)
      code = basic::kBadData;
    else
      std::ranges::copy(answer, region.data);
  }
  answerPartnerJob(a, code);
}

// No module of the station is a partner: neither rack nor DP slaves hold FMs or CPs of this kind.
template <typename A>
void askModule(A& a) {
  answerPartnerJob(a, a.flag("REQ") ? basic::kNoAddress : basic::kIdle);
}

}  // namespace

void sendToPartner(Sfc<65>& a) {
  BasicCommunication::Order order{MessageKind::Send};
  order.id = a.value("REQ_ID");
  const Region data = dataOf(a, "SD", Access::Read, order);
  transfer(a, order, data);
}

void getFromPartner(Sfc<67>& a) {
  BasicCommunication::Order order{MessageKind::Get};
  order.there = a.any("VAR_ADDR");
  const Region data = dataOf(a, "RD", Access::Write, order);
  transfer(a, order, data);
}

void putToPartner(Sfc<68>& a) {
  BasicCommunication::Order order{MessageKind::Put};
  order.there = a.any("VAR_ADDR");
  const Region data = dataOf(a, "SD", Access::Read, order);
  transfer(a, order, data);
}

// EN_DT 0: is there anything? 1: fetch the oldest; with RD = NIL it is discarded.
void receiveFromPartner(Sfc<66>& a) {
  const Instant now = a.machine().clock;
  const bool fetch = a.flag("EN_DT"), discard = fetch && isNil(a.any("RD"));
  BasicCommunication::Order order;
  Region region;
  if (fetch && !discard) region = dataOf(a, "RD", Access::Write, order);
  a.partners().receive(now);
  BasicCommunication::Received* const oldest = a.partners().oldest();
  const auto length = oldest == nullptr ? 0u : static_cast<std::uint32_t>(oldest->data.size());
  const bool bad = order.dataError != 0 || (fetch && !discard && region.length < length);
  a.set("REQ_ID", oldest == nullptr ? 0 : oldest->id);
  a.set("NDA", oldest != nullptr && !bad);
  if (bad) return a.status(basic::kBadData);
  if (oldest == nullptr) return a.status(basic::kIdle);
  if (fetch && !discard) std::ranges::copy(oldest->data, region.data);
  oldest->seen = true;
  if (fetch) a.partners().finishOldest(discard ? basic::kDiscarded : 0, now);
  a.status(discard ? 0 : length);
}

void abortConnection(Sfc<69>& a) {
  const std::uint32_t partner = a.value("DEST_ID");
  if (partner > BasicCommunication::kHighestAddress)
    return answerPartnerJob(a, a.flag("REQ") ? basic::kNoAddress : basic::kIdle);
  answerPartnerJob(
      a, a.partners().abort(static_cast<std::uint8_t>(partner), a.flag("REQ"), a.machine().clock));
}

void getFromModule(Sfc<72>& a) { askModule(a); }
void putToModule(Sfc<73>& a) { askModule(a); }
void abortModule(Sfc<74>& a) { askModule(a); }

}  // namespace merker::system
