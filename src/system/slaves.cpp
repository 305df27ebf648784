// SFC 13 DPNRM_DG, 14 DPRD_DAT, 15 DPWR_DAT (S7-SFC-06, -07). They are for DP slaves; all modules
// that there are stand in the racks of the CPU.
#include "system/module_access.h"

namespace merker::system {
namespace {

void refuse(Arguments& a, std::uint32_t area, std::size_t address, std::size_t record) {
  constexpr std::uint32_t kUnknown = 0x8090, kNotByte = 0x8092, kNoSlave = 0x8093;
  const auto module = moduleAt(a.modules(), area, a.value(address), AddressRule::Base);
  if (!module) return a.status(kUnknown);
  a.status(a.any(record).type != TypeCode::Byte ? kNotByte : kNoSlave);
}

}  // namespace

void readSlaveDiagnosis(Arguments& a) {
  enum { REQ, LADDR, RECORD, BUSY };
  a.set(BUSY, 0);
  refuse(a, kInputArea, LADDR, RECORD);
}

void readSlaveData(Arguments& a) { refuse(a, kInputArea, 0, 1); }
void writeSlaveData(Arguments& a) { refuse(a, kOutputArea, 0, 1); }

}  // namespace merker::system
