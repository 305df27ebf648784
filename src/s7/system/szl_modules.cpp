// Diagnostic data of modules (S7-DIAG-05): records 0 and 1 by address or by slot.
#include "system/module_access.h"
#include "system/szl.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kNoModule = 0x8083, kNoAnswer = 0x8087, kNoDiagnostics = 0x8089;

void record(const SzlSource& source, const std::optional<ModuleInfo>& module, std::uint8_t number,
            SzlList& list) {
  if (!module) {
    list.error = kNoModule;
  } else if (!module->plugged) {
    list.error = kNoAnswer;
  } else if (!module->diagnostics) {
    list.error = kNoDiagnostics;
  } else {
    const RecordResult result = source.modules->readRecord(module->place, number, list.data);
    if (result != RecordResult::Good) list.error = kNoAnswer;
    list.recordLength = static_cast<std::uint16_t>(list.data.size());
  }
}

// Bit 15 of INDEX: an address of outputs.
std::optional<ModuleInfo> byAddress(const SzlSource& source, std::uint32_t index) {
  const std::uint32_t area = (index & 0x8000) != 0 ? kOutputArea : kInputArea;
  return moduleAt(source.modules, area, index & 0x7FFF, AddressRule::Base);
}

}  // namespace

void szlRecord0(const SzlSource& source, std::uint32_t index, SzlList& list) {
  record(source, byAddress(source, index), 0, list);
}

void szlRecord1BySlot(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const ModulePlace place{static_cast<std::uint8_t>(index >> 8), static_cast<std::uint8_t>(index)};
  record(source, moduleIn(source.modules, place), 1, list);
}

void szlRecord1ByAddress(const SzlSource& source, std::uint32_t index, SzlList& list) {
  record(source, byAddress(source, index), 1, list);
}

}  // namespace merker::system
