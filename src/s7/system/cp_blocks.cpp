// FC 5 AG_SEND, FC 6 AG_RECV of a CP 343-1, and FC 50, 60, which do the same (S7-SFB-10; "Program
// blocks for SIMATIC NET S7 CPs"). A job is that of its connection, whichever call begins it.
#include <utility>

#include "system/call.h"
#include "system/mail_data.h"
#include "system/module_access.h"
#include "system/partner_memory.h"
#include "system/send_receive.h"

namespace merker::system {
namespace {

using Connection = SendReceive::Connection;

// STATUS, besides those of SendReceive.
namespace cp {
constexpr std::uint32_t kNoData = 0x8180, kJobActive = 0x8181, kNotConfigured = 0x8183,
                        kWrongType = 0x8184, kTooShort = 0x8185, kWrongId = 0x8186,
                        kBadSource = 0x8F22, kBadTarget = 0x8F23, kBlockMissing = 0x8F3A,
                        kNoCp = 0x8090;
}  // namespace cp

// `done`: DONE or NDR.
template <typename A>
void showCp(A& a, NameIn<A> done, bool is, std::uint32_t status) {
  a.set(done, is);
  a.set("ERROR", 0);
  a.set("STATUS", status);
}

template <typename A>
void showCpError(A& a, NameIn<A> done, std::uint32_t status) {
  a.set(done, 0);
  a.set("ERROR", 1);
  a.set("STATUS", status);
  a.fail();
}

// 0, or why LADDR names no CP that answers.
std::uint32_t whyNoCp(Modules* modules, std::uint32_t address) {
  const auto module = moduleAt(modules, kInputArea, address, AddressRule::Base);
  if (!module || !module->ethernet) return cp::kNoCp;
  return refusal(*module);
}

// Null, and the error is shown: ID and LADDR name none.
template <typename A>
Connection* connectionOf(A& a, NameIn<A> done) {
  const std::uint32_t id = a.value("ID");
  std::uint32_t error = whyNoCp(a.modules(), a.value("LADDR"));
  if (id < 1 || id > CpConnectionParameters::kHighestId) error = cp::kWrongId;
  Connection* const found = error == 0 ? a.sendReceive().find(id) : nullptr;
  if (error == 0 && found == nullptr) error = cp::kNotConfigured;
  if (error != 0) showCpError(a, done, error);
  return found;
}

// Whole bytes of E, A, M or a data block.
bool isArea(const AnyPointer& where) {
  return where.syntax == AnyPointer{}.syntax && isElementary(where.type) &&
         where.type != TypeCode::Bool && where.count > 0;
}

std::uint32_t memoryError(const Region& region, std::uint32_t otherwise) {
  return region.error == cpu::ErrorCode::DbMissing ? cp::kBlockMissing : otherwise;
}

// 0 and the data to send, or why there are none.
template <typename A>
std::uint32_t dataToSend(A& a, const Connection& one, SendReceive::Bytes& data) {
  const AnyPointer where = a.any("SEND");
  const std::int32_t length = a.integer("LEN");
  if (!isArea(where)) return cp::kWrongType;
  if (length < 1) return cp::kBadSource;
  const auto octets = static_cast<std::uint32_t>(length);
  if (octets > byteCount(where) || octets > one.longest()) return cp::kTooShort;
  const Region region = a.region(where, octets, cpu::Access::Read);
  if (!region) return memoryError(region, cp::kBadSource);
  data.assign(region.data, region.data + octets);
  return one.kind == ConnectionKind::Mail && !mailOf(data) ? cp::kWrongType : 0;
}

template <typename A>
void beginSending(A& a, Connection& one) {
  SendReceive::Bytes data;
  const std::uint32_t error = one.up ? dataToSend(a, one, data) : SendReceive::kNoConnection;
  if (error != 0) return showCpError(a, "DONE", error);
  SendReceive::begin(one, std::move(data));
  showCp(a, "DONE", false, cp::kJobActive);
}

template <typename A>
void endSending(A& a, Connection& one) {
  const std::uint16_t result = *std::exchange(one.result, std::nullopt);
  one.sends = false;
  result == SendReceive::kSent ? showCp(a, "DONE", true, 0) : showCpError(a, "DONE", result);
}

template <typename A>
void sendOver(A& a) {
  Connection* const one = connectionOf(a, "DONE");
  if (one == nullptr) return;
  if (one->result) return endSending(a, *one);
  if (one->sends) return showCp(a, "DONE", false, cp::kJobActive);
  a.flag("ACT") ? beginSending(a, *one) : showCp(a, "DONE", false, 0);
}

// A stream fills the whole area; of the other kinds the next telegram must fit into it.
template <typename A>
void takeData(A& a, Connection& one, const AnyPointer& where) {
  const std::uint32_t room = byteCount(where);
  if (one.isStream() && one.waiting < room) return showCp(a, "NDR", false, cp::kJobActive);
  const std::size_t octets = one.isStream() ? room : one.in.front().size();
  if (octets > room) return showCpError(a, "NDR", cp::kTooShort);
  const Region region = a.region(where, static_cast<std::uint32_t>(octets), cpu::Access::Write);
  if (!region) return showCpError(a, "NDR", memoryError(region, cp::kBadTarget));
  std::ranges::copy(SendReceive::take(one, octets), region.data);
  a.set("LEN", static_cast<std::uint32_t>(octets));
  showCp(a, "NDR", true, 0);
}

template <typename A>
void receiveOver(A& a) {
  a.set("LEN", 0);
  Connection* const one = connectionOf(a, "NDR");
  if (one == nullptr) return;
  const AnyPointer where = a.any("RECV");
  if (!isArea(where)) return showCpError(a, "NDR", cp::kWrongType);
  if (one->waiting > 0) return takeData(a, *one, where);
  one->up ? showCp(a, "NDR", false, cp::kNoData)
          : showCpError(a, "NDR", SendReceive::kNoConnection);
}

}  // namespace

void sendToCp(CpFc<5>& a) { sendOver(a); }
void sendToCp(CpFc<50>& a) { sendOver(a); }
void receiveFromCp(CpFc<6>& a) { receiveOver(a); }
void receiveFromCp(CpFc<60>& a) { receiveOver(a); }

}  // namespace merker::system
