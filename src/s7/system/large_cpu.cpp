// Functions of larger CPUs: SFC 25 COMPRESS, 26 UPDAT_PI, 27 UPDAT_PO, 48 SNC_RTCB (S7-SFC-10,
// -11).
#include "system/call.h"

namespace merker::system {
namespace {

// Part 0 is the whole process image; no other part is configured.
template <typename A>
bool wholeImage(A& a) {
  constexpr std::uint32_t kNoSuchPart = 0x8090;
  a.set("FLADDR", 0);
  if (a.value("PART") == 0) return true;
  a.status(kNoSuchPart);
  return false;
}

}  // namespace

// Work memory has no gaps: it is done at once.
void compressMemory(Sfc<25>& a) {
  a.set("BUSY", 0);
  a.set("DONE", 1);
  a.status(0);
}

void updateInputs(Sfc<26>& a) {
  if (!wholeImage(a)) return;
  a.machine().areas.readInputs();
  a.status(0);
}

void updateOutputs(Sfc<27>& a) {
  if (!wholeImage(a)) return;
  a.machine().areas.writeOutputs();
  a.cpu().modules().written(0, a.machine().areas.imageBytes);
  a.status(0);
}

void synchroniseClocks(Sfc<48>& a) {
  constexpr std::uint32_t kNoMaster = 0x0001;
  a.status(kNoMaster);
}

}  // namespace merker::system
