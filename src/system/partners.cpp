// SFC 65 X_SEND, 66 X_RCV, 67 X_GET, 68 X_PUT, 69 X_ABORT (S7-SFC-23): communication over MPI
// without configured connections. A station alone has no partners: a job begins and ends with 80A1.
#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kNoAddress = 0x8090, kNoData = 0x8092, kNoPartner = 0x80A1;
constexpr std::uint32_t kHighestAddress = 126, kLongest = 76;

// 0, or why these data cannot be sent or received.
std::uint32_t dataError(Arguments& a, std::size_t parameter, cpu::Access access) {
  const AnyPointer where = a.any(parameter);
  const std::uint32_t bytes = byteCount(where);
  if (bytes == 0 || bytes > kLongest) return kNoData;
  return a.region(where, bytes, access) ? 0 : kNoData;
}

std::uint32_t exchange(Arguments& a, std::uint16_t function, std::uint32_t partner,
                       std::uint32_t error) {
  const Job job{function, partner, 0};
  if (a.jobs().end(job)) return kNoPartner;
  if (!a.flag(0)) return kNoJob;
  if (partner > kHighestAddress) return kNoAddress;
  if (error != 0) return error;
  a.jobs().begin(job);
  return kJobBegins;
}

void answer(Arguments& a, std::size_t busy, std::uint32_t code) {
  a.set(busy, code == kJobBegins);
  a.status(code);
}

}  // namespace

void sendToPartner(Arguments& a) {
  enum { REQ, CONT, DEST_ID, REQ_ID, SD, BUSY };
  answer(a, BUSY, exchange(a, 65, a.value(DEST_ID), dataError(a, SD, cpu::Access::Read)));
}

// EN_DT 0: is there anything? 1: fetch it. Nobody has sent anything.
void receiveFromPartner(Arguments& a) {
  enum { EN_DT, REQ_ID, NDA, RD };
  a.set(REQ_ID, 0);
  a.set(NDA, 0);
  if (a.flag(EN_DT) && dataError(a, RD, cpu::Access::Write) != 0) return a.status(kNoData);
  a.status(kNoJob);
}

void getFromPartner(Arguments& a) {
  enum { REQ, CONT, DEST_ID, VAR_ADDR, BUSY, RD };
  answer(a, BUSY, exchange(a, 67, a.value(DEST_ID), dataError(a, RD, cpu::Access::Write)));
}

void putToPartner(Arguments& a) {
  enum { REQ, CONT, DEST_ID, VAR_ADDR, SD, BUSY };
  answer(a, BUSY, exchange(a, 68, a.value(DEST_ID), dataError(a, SD, cpu::Access::Read)));
}

// There never is a connection to abort.
void abortConnection(Arguments& a) {
  enum { REQ, DEST_ID, BUSY };
  const std::uint32_t partner = a.value(DEST_ID);
  const Job job{69, partner, 0};
  if (a.jobs().end(job)) return answer(a, BUSY, 0);
  if (!a.flag(REQ)) return answer(a, BUSY, kNoJob);
  if (partner > kHighestAddress) return answer(a, BUSY, kNoAddress);
  a.jobs().begin(job);
  answer(a, BUSY, kJobBegins);
}

}  // namespace merker::system
