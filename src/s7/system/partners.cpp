// SFC 65 X_SEND, 66 X_RCV, 67 X_GET, 68 X_PUT, 69 X_ABORT (S7-SFC-23): communication over MPI
// without configured connections. A station alone has no partners: a job begins and ends with 80A1.
#include "system/call.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kNoAddress = 0x8090, kNoData = 0x8092, kNoPartner = 0x80A1;
constexpr std::uint32_t kHighestAddress = 126, kLongest = 76;

// 0, or why these data cannot be sent or received.
template <typename A>
std::uint32_t dataError(A& a, NameIn<A> parameter, cpu::Access access) {
  const AnyPointer where = a.any(parameter);
  const std::uint32_t bytes = byteCount(where);
  if (bytes == 0 || bytes > kLongest) return kNoData;
  return a.region(where, bytes, access) ? 0 : kNoData;
}

template <typename A>
std::uint32_t exchange(A& a, std::uint32_t error) {
  const std::uint32_t partner = a.value("DEST_ID");
  const Job job{a.functionNumber(), partner, 0};
  if (a.jobs().end(job)) return kNoPartner;
  if (!a.flag("REQ")) return kNoJob;
  if (partner > kHighestAddress) return kNoAddress;
  if (error != 0) return error;
  a.jobs().begin(job);
  return kJobBegins;
}

}  // namespace

void sendToPartner(Sfc<65>& a) { answerJob(a, exchange(a, dataError(a, "SD", cpu::Access::Read))); }

// EN_DT 0: is there anything? 1: fetch it. Nobody has sent anything.
void receiveFromPartner(Sfc<66>& a) {
  a.set("REQ_ID", 0);
  a.set("NDA", 0);
  if (a.flag("EN_DT") && dataError(a, "RD", cpu::Access::Write) != 0) return a.status(kNoData);
  a.status(kNoJob);
}

void getFromPartner(Sfc<67>& a) {
  answerJob(a, exchange(a, dataError(a, "RD", cpu::Access::Write)));
}

void putToPartner(Sfc<68>& a) { answerJob(a, exchange(a, dataError(a, "SD", cpu::Access::Read))); }

// There never is a connection to abort.
void abortConnection(Sfc<69>& a) {
  const std::uint32_t partner = a.value("DEST_ID");
  const Job job{a.functionNumber(), partner, 0};
  if (a.jobs().end(job)) return answerJob(a, 0);
  if (!a.flag("REQ")) return answerJob(a, kNoJob);
  if (partner > kHighestAddress) return answerJob(a, kNoAddress);
  a.jobs().begin(job);
  answerJob(a, kJobBegins);
}

}  // namespace merker::system
