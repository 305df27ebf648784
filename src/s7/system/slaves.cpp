// SFC 11 DPSYC_FR, 13 DPNRM_DG, 14 DPRD_DAT, 15 DPWR_DAT (S7-SFC-06, -07): diagnosis of DP slaves,
// and all bytes of one of their modules at once.
#include <algorithm>

#include "system/call.h"
#include "system/module_access.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kNoSuchModule = 0x8090, kNoByteField = 0x8092, kNoSlave = 0x8093;
constexpr std::uint32_t kNoAccessToRead = 0x80A0, kNoAccessToWrite = 0x80A1, kBadLength = 0x80B1;
constexpr std::uint32_t kJobsExhausted = 0x80C3;

// The bytes of the slave's module, or why there are none.
struct SlaveData {
  AddressRange bytes{};
  AnyPointer record{};
  std::uint32_t code = 0;
};

template <typename A>
SlaveData slaveData(A& a, std::uint32_t area, std::uint32_t noAccess) {
  SlaveData data;
  data.record = a.any("RECORD");
  const auto module = moduleAt(a.modules(), area, a.value("LADDR"), AddressRule::Base);
  if (!module)
    data.code = kNoSuchModule;
  else if (data.record.type != TypeCode::Byte)
    data.code = kNoByteField;
  else if (!module->distributed)
    data.code = kNoSlave;
  else if (!module->plugged)
    data.code = noAccess;
  else
    data.bytes = area == kInputArea ? module->inputs : module->outputs;
  if (data.code == 0 && data.record.count != data.bytes.count) data.code = kBadLength;
  return data;
}

}  // namespace

// MODE: bit 2 UNFREEZE, 3 FREEZE, 4 UNSYNC, 5 SYNC; of each pair one.
void commandSlaves(Sfc<11>& a) {
  constexpr std::uint32_t kWrongGroup = 0x8325, kWrongMode = 0x8425, kNoMaster = 0x8090;
  constexpr std::uint32_t kFreezes = 0x0C, kSyncs = 0x30;
  const std::uint32_t mode = a.value("MODE"), groups = a.value("GROUP");
  const bool both = (mode & kFreezes) == kFreezes || (mode & kSyncs) == kSyncs;
  const std::uint32_t wrong = a.modules() == nullptr ? kNoMaster
                              : groups == 0          ? kWrongGroup
                              : mode == 0 || both || (mode & ~(kFreezes | kSyncs)) != 0 ? kWrongMode
                                                                                        : 0;
  if (wrong != 0) return answerJob(a, wrong);
  const Job job{a.functionNumber(), a.value("LADDR"), groups << 8 | mode};
  if (!a.jobs().end(job)) {
    if (a.flag("REQ") && a.jobs().full()) return answerJob(a, kJobsExhausted);
    if (a.flag("REQ")) a.jobs().begin(job);
    return answerJob(a, a.flag("REQ") ? kJobBegins : kNoJob);
  }
  answerJob(a, a.modules()->command({.master = a.value("LADDR"),
                                     .groups = static_cast<std::uint8_t>(groups),
                                     .commands = static_cast<std::uint8_t>(mode)},
                                    a.machine().clock));
}

// The job ends at the second call; RET_VAL says how many bytes there are.
void readSlaveDiagnosis(Sfc<13>& a) {
  const AnyPointer record = a.any("RECORD");
  const std::uint32_t address = a.value("LADDR");
  const auto diagnosis =
      a.modules() == nullptr ? std::nullopt : a.modules()->slaveDiagnosis(address);
  const bool known = diagnosis || moduleAt(a.modules(), kInputArea, address, AddressRule::Base);
  const std::uint32_t wrong = !known                                                 ? kNoSuchModule
                              : record.type != TypeCode::Byte                        ? kNoByteField
                              : !diagnosis                                           ? kNoSlave
                              : record.count < diagnosis->size() && record.count < 6 ? kBadLength
                                                                                     : 0;
  a.set("BUSY", 0);
  if (wrong != 0) return a.status(wrong);
  const Job job{a.functionNumber(), address, 0};
  if (!a.jobs().end(job)) {
    if (!a.flag("REQ")) return a.status(kNoJob);
    if (a.jobs().full()) return a.status(kJobsExhausted);
    a.jobs().begin(job);
    return answerJob(a, kJobBegins);
  }
  const auto length =
      std::min(static_cast<std::uint32_t>(diagnosis->size()), std::uint32_t{record.count});
  const Region region = a.region(record, length, cpu::Access::Write);
  if (!region) return a.parameterError("RECORD", region.error);
  std::copy_n(diagnosis->begin(), length, region.data);
  a.status(length);
}

void readSlaveData(Sfc<14>& a) {
  const SlaveData data = slaveData(a, kInputArea, kNoAccessToRead);
  if (data.code != 0) return a.status(data.code);
  a.cpu().modules().reading();
  const Region region = a.region(data.record, data.bytes.count, cpu::Access::Write);
  if (!region) return a.parameterError("RECORD", region.error);
  std::copy_n(&a.machine().areas.inputs[data.bytes.first], data.bytes.count, region.data);
  a.status(0);
}

// Where the process image has these bytes it gets them as well.
void writeSlaveData(Sfc<15>& a) {
  const SlaveData data = slaveData(a, kOutputArea, kNoAccessToWrite);
  if (data.code != 0) return a.status(data.code);
  const Region region = a.region(data.record, data.bytes.count, cpu::Access::Read);
  if (!region) return a.parameterError("RECORD", region.error);
  cpu::Areas& areas = a.machine().areas;
  std::copy_n(region.data, data.bytes.count, &areas.outputs[data.bytes.first]);
  for (std::uint32_t i = 0; i < data.bytes.count; ++i)
    if (data.bytes.first + i < areas.imageBytes)
      *areas.output(data.bytes.first + i) = region.data[i];
  a.cpu().modules().written(data.bytes.first, data.bytes.count);
  a.status(0);
}

}  // namespace merker::system
