// SFC 13 DPNRM_DG, 14 DPRD_DAT, 15 DPWR_DAT (S7-SFC-06, -07). They are for DP slaves; all modules
// that there are stand in the racks of the CPU.
#include "system/call.h"
#include "system/module_access.h"

namespace merker::system {
namespace {

template <typename A>
void refuse(A& a, std::uint32_t area) {
  constexpr std::uint32_t kUnknown = 0x8090, kNotByte = 0x8092, kNoSlave = 0x8093;
  const auto module = moduleAt(a.modules(), area, a.value("LADDR"), AddressRule::Base);
  if (!module) return a.status(kUnknown);
  a.status(a.any("RECORD").type != TypeCode::Byte ? kNotByte : kNoSlave);
}

}  // namespace

void readSlaveDiagnosis(Sfc<13>& a) {
  a.set("BUSY", 0);
  refuse(a, kInputArea);
}

void readSlaveData(Sfc<14>& a) { refuse(a, kInputArea); }
void writeSlaveData(Sfc<15>& a) { refuse(a, kOutputArea); }

}  // namespace merker::system
