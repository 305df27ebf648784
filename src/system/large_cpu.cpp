// Functions of larger CPUs: SFC 25 COMPRESS, 26 UPDAT_PI, 27 UPDAT_PO, 48 SNC_RTCB (S7-SFC-10,
// -11).
#include "system/arguments.h"

namespace merker::system {
namespace {

// Part 0 is the whole process image; no other part is configured.
bool wholeImage(Arguments& a) {
  constexpr std::uint32_t kNoSuchPart = 0x8090;
  a.set(1, 0);
  if (a.value(0) == 0) return true;
  a.status(kNoSuchPart);
  return false;
}

}  // namespace

// Work memory has no gaps: it is done at once.
void compressMemory(Arguments& a) {
  a.set(0, 0);
  a.set(1, 1);
  a.status(0);
}

void updateInputs(Arguments& a) {
  if (!wholeImage(a)) return;
  a.machine().areas.readInputs();
  a.status(0);
}

void updateOutputs(Arguments& a) {
  if (!wholeImage(a)) return;
  a.machine().areas.writeOutputs();
  a.cpu().outputsWritten(0, a.machine().areas.imageBytes);
  a.status(0);
}

void synchroniseClocks(Arguments& a) {
  constexpr std::uint32_t kNoMaster = 0x0001;
  a.status(kNoMaster);
}

}  // namespace merker::system
