// SFB 12 BSEND, 13 BRCV, 14 GET, 15 PUT, and FB 12 to 15 of a CP 343-1 (S7-SFB-10; System and
// Standard Functions, volume 2/2, chapter 21). What they begin is carried at the end of the cycle;
// a result is shown in one call.
#include "system/partner_block.h"

namespace merker::system {
namespace {

// LEN replaces the length of SD_1.
template <typename A>
Made blockSendJob(A& a) {
  Taken taken = takeValue(a, a.any("SD_1"));
  if (taken.status != PartnerStatus::Done) return {taken.status};
  const std::uint32_t length = a.value("LEN");
  if (length == 0 || length > taken.octets.size()) return {PartnerStatus::WrongLength};
  taken.octets.resize(length);
  return {.job = {.rid = a.value("R_ID"), .values = {std::move(taken.octets)}}};
}

template <typename A>
constexpr NameIn<A> kAddresses[] = {"ADDR_1", "ADDR_2", "ADDR_3", "ADDR_4"};
template <typename A>
constexpr NameIn<A> kTargets[] = {"RD_1", "RD_2", "RD_3", "RD_4"};
template <typename A>
constexpr NameIn<A> kSources[] = {"SD_1", "SD_2", "SD_3", "SD_4"};

// The pairs of ADDR_i and RD_i or SD_i: those from the first unused one on are none. Each has the
// same length on both sides.
template <typename A>
std::optional<std::vector<s7comm::AnyItem>> itemsOf(A& a, std::span<const NameIn<A>> addresses,
                                                    std::span<const NameIn<A>> places) {
  std::vector<s7comm::AnyItem> items;
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    const AnyPointer there = a.any(addresses[i]), here = a.any(places[i]);
    if (isNil(there) && isNil(here)) break;
    const auto item = itemOf(there);
    if (!item || byteCount(there) != byteCount(here)) return std::nullopt;
    items.push_back(*item);
  }
  if (items.empty()) return std::nullopt;
  return items;
}

template <typename A>
Made getJob(A& a) {
  auto items = itemsOf<A>(a, kAddresses<A>, kTargets<A>);
  if (!items) return {PartnerStatus::WrongLength};
  return {.job = {.kind = PartnerJob::Kind::Get, .items = std::move(*items)}};
}

template <typename A>
Made putJob(A& a) {
  auto items = itemsOf<A>(a, kAddresses<A>, kSources<A>);
  if (!items) return {PartnerStatus::WrongLength};
  Made made{.job = {.kind = PartnerJob::Kind::Put, .items = std::move(*items)}};
  for (std::size_t i = 0; i < made.job.items.size(); ++i) {
    Taken taken = takeValue(a, a.any(kSources<A>[i]));
    if (taken.status != PartnerStatus::Done) return {taken.status};
    made.job.values.push_back(std::move(taken.octets));
  }
  return made;
}

template <typename A>
PartnerStatus storeGot(A& a, const std::vector<s7comm::Bytes>& values) {
  for (std::size_t i = 0; i < values.size() && i < std::size(kTargets<A>); ++i) {
    const auto status = storeValue(a, a.any(kTargets<A>[i]), values[i], true);
    if (status != PartnerStatus::Done) return status;
  }
  return PartnerStatus::Done;
}

template <typename A>
void takeTelegram(A& a, Connections::Receiver& receiver) {
  const s7comm::Telegram telegram = a.connections().take(receiver);
  if (telegram.tooLong) {
    const PartnerStatus place = receivableAt(a, a.any("RD_1"));
    return showFailed(a, "NDR", place == PartnerStatus::Done ? PartnerStatus::WrongLength : place);
  }
  const auto status = storeValue(a, a.any("RD_1"), telegram.octets, false);
  if (status != PartnerStatus::Done) return showFailed(a, "NDR", status);
  a.set("LEN", static_cast<std::uint32_t>(telegram.octets.size()));
  showDone(a, "NDR", true);
}

// Nothing is there to be taken.
template <typename A>
void awaitTelegram(A& a, const Connections::Receiver& receiver) {
  if (!a.connections().connected(*receiver.connection))
    return showFailed(a, "NDR", PartnerStatus::NoConnection);
  if (receiver.begun == 0) return showDone(a, "NDR", false, kJobRuns);
  a.set("LEN", static_cast<std::uint32_t>(receiver.begun));
  showDone(a, "NDR", false, kBytesCome);
}

template <typename A>
void sendBlocksOf(A& a) {
  carryOutJob<A>(a, "DONE", a.flag("R"), blockSendJob<A>, nothingToStore<A>);
}

template <typename A>
void getWith(A& a) {
  carryOutJob<A>(a, "NDR", false, getJob<A>, storeGot<A>);
}

template <typename A>
void putWith(A& a) {
  carryOutJob<A>(a, "DONE", false, putJob<A>, nothingToStore<A>);
}

template <typename A>
void receiveFrom(A& a) {
  Connections::Receiver* const receiver = a.connections().receiver(instanceOfCall(a));
  if (receiver == nullptr) return showFailed(a, "NDR", PartnerStatus::TooManyJobs);
  const bool enabled = a.flag("EN_R");
  if (!enabled) {
    if (receiver->connection) a.connections().enable(*receiver, false, 0);
    return showDone(a, "NDR", false);
  }
  const PartnerStatus bound = bindReceiver(a, *receiver, true);
  if (bound != PartnerStatus::Done) return showFailed(a, "NDR", bound);
  // Where nothing can be stored, each telegram is refused: its sender must not take it for
  // received.
  const AnyPointer place = a.any("RD_1");
  const bool takes = receivableAt(a, place) == PartnerStatus::Done;
  a.connections().enable(*receiver, true, takes ? byteCount(place) : 0);
  receiver->telegrams.empty() ? awaitTelegram(a, *receiver) : takeTelegram(a, *receiver);
}

}  // namespace

void sendBlocks(Sfb<12>& a) { sendBlocksOf(a); }
void sendBlocks(CpFb<12>& a) { sendBlocksOf(a); }
void receiveBlocks(Sfb<13>& a) { receiveFrom(a); }
void receiveBlocks(CpFb<13>& a) { receiveFrom(a); }
void getFromConnection(Sfb<14>& a) { getWith(a); }
void getFromConnection(CpFb<14>& a) { getWith(a); }
void putToConnection(Sfb<15>& a) { putWith(a); }
void putToConnection(CpFb<15>& a) { putWith(a); }

}  // namespace merker::system
