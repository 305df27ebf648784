// SFB 8 USEND, 9 URCV, and FB 8 and 9 of a CP 343-1 (S7-SFB-10; System and Standard Functions,
// volume 2/2, chapter 21). The partner's program is not asked: a job is done when it is sent, and
// what nobody receives is lost.
#include <array>

#include "system/partner_block.h"

namespace merker::system {
namespace {

// SFBs have four areas, the FBs of an S7-300 one: no length of theirs is printed for more
// (21-4, "Exact User Data Size").
template <typename A>
constexpr std::array<NameIn<A>, 1> kSent = {"SD_1"};
template <>
constexpr std::array<NameIn<Sfb<8>>, 4> kSent<Sfb<8>> = {"SD_1", "SD_2", "SD_3", "SD_4"};
template <typename A>
constexpr std::array<NameIn<A>, 1> kReceived = {"RD_1"};
template <>
constexpr std::array<NameIn<Sfb<9>>, 4> kReceived<Sfb<9>> = {"RD_1", "RD_2", "RD_3", "RD_4"};

// From the first unused one on they are none.
template <typename A>
std::vector<AnyPointer> areasOf(A& a, std::span<const NameIn<A>> names) {
  std::vector<AnyPointer> areas;
  for (const NameIn<A> name : names) {
    const AnyPointer where = a.any(name);
    if (isNil(where)) break;
    areas.push_back(where);
  }
  return areas;
}

template <typename A>
Made sendJob(A& a) {
  Made made{.job = {.kind = PartnerJob::Kind::Send, .rid = a.value("R_ID")}};
  for (const AnyPointer& where : areasOf<A>(a, kSent<A>)) {
    Taken taken = takeValue(a, where);
    if (taken.status != PartnerStatus::Done) return {taken.status};
    made.job.areas.push_back({unitOf(where), std::move(taken.octets)});
  }
  if (made.job.areas.empty()) return {PartnerStatus::WrongLength};
  return made;
}

// Types must match; octets are whatever the receiver takes them for.
bool matches(const AnyPointer& where, const s7comm::SentArea& area) {
  const s7comm::DataUnit unit = unitOf(where);
  const bool octets = area.unit == s7comm::DataUnit::Octets && unit != s7comm::DataUnit::Bit;
  return (area.unit == unit || octets) && !area.octets.empty() &&
         area.octets.size() <= byteCount(where);
}

// All areas, or none.
PartnerStatus storeNotice(Arguments& a, const std::vector<AnyPointer>& places,
                          const s7comm::Notice& notice) {
  if (places.size() != notice.areas.size()) return PartnerStatus::WrongLength;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PartnerStatus place = receivableAt(a, places[i]);
    if (place != PartnerStatus::Done) return place;
    if (!matches(places[i], notice.areas[i])) return PartnerStatus::WrongLength;
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    (void)storeValue(a, places[i], notice.areas[i].octets, false);
  return PartnerStatus::Done;
}

template <typename A>
void takeNotice(A& a, Connections::Receiver& receiver) {
  const s7comm::Notice notice = std::move(*receiver.notice);
  receiver.notice.reset();
  const PartnerStatus status = storeNotice(a, areasOf<A>(a, kReceived<A>), notice);
  if (status != PartnerStatus::Done) return showFailed(a, "NDR", status);
  showDone(a, "NDR", true, notice.overwrote ? kOverwritten : 0);
}

template <typename A>
void listen(A& a) {
  Connections::Receiver* const receiver = a.connections().receiver(instanceOfCall(a));
  if (receiver == nullptr) return showFailed(a, "NDR", PartnerStatus::TooManyJobs);
  if (!a.flag("EN_R")) {
    if (receiver->connection) a.connections().enable(*receiver, false, 0);
    receiver->notice.reset();
    return showDone(a, "NDR", false);
  }
  const PartnerStatus bound = bindReceiver(a, *receiver, false);
  if (bound != PartnerStatus::Done) return showFailed(a, "NDR", bound);
  a.connections().enable(*receiver, true, 0);
  if (receiver->notice) return takeNotice(a, *receiver);
  a.connections().connected(*receiver->connection)
      ? showDone(a, "NDR", false, kJobRuns)
      : showFailed(a, "NDR", PartnerStatus::NoConnection);
}

template <typename A>
void sendUncoordinatedOf(A& a) {
  carryOutJob<A>(a, "DONE", false, sendJob<A>, nothingToStore<A>);
}

}  // namespace

void sendUncoordinated(Sfb<8>& a) { sendUncoordinatedOf(a); }
void sendUncoordinated(CpFb<8>& a) { sendUncoordinatedOf(a); }
void receiveUncoordinated(Sfb<9>& a) { listen(a); }
void receiveUncoordinated(CpFb<9>& a) { listen(a); }

}  // namespace merker::system
