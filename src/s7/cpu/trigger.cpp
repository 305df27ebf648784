#include "cpu/trigger.h"

#include <algorithm>
#include <iterator>

#include "base/bytes.h"
#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

using Kind = ModuleEvent::Kind;

struct ModuleRow {
  std::uint8_t ob;
  Kind coming, going;
};
constexpr ModuleRow kModuleRows[] = {
    {40, Kind::HardwareInterrupt, Kind::HardwareInterrupt},
    {82, Kind::DiagnosticComing, Kind::DiagnosticGoing},
    {83, Kind::Removed, Kind::Inserted},
    {86, Kind::RackFailed, Kind::RackReturned},
};

struct ErrorRow {
  std::uint8_t ob, fault;
  bool comesAndGoes;
};
constexpr ErrorRow kErrorRows[] = {
    {80, 0x01, false}, {81, 0x22, true}, {84, 0x81, true}, {85, 0xA1, false}, {87, 0xE1, false}};

template <typename Rows>
auto rowOf(const Rows& rows, std::uint32_t ob) {
  return std::find_if(std::begin(rows), std::end(rows),
                      [&](const auto& row) { return row.ob == ob; });
}

void moduleEvent(Cpu& cpu, const ModuleRow& row, const Trigger& trigger) {
  ModuleEvent event{.kind = trigger.going ? row.going : row.coming,
                    .address = trigger.address,
                    .points = trigger.points};
  storeDWord(event.data.data(), trigger.data);
  cpu.moduleEvents().happened(event);
}

// Errors of updating the image come and go too (S7-OBI-10).
bool comesAndGoes(const ErrorRow& row, std::uint8_t fault) {
  return row.comesAndGoes || (row.ob == 85 && fault >= 0xB1 && fault <= 0xB4);
}

void error(Cpu& cpu, const ErrorRow& row, const Trigger& trigger) {
  if (row.ob == 81 && trigger.fault == 0) return cpu.moduleEvents().setBattery(!trigger.going);
  const std::uint8_t fault = trigger.fault == 0 ? row.fault : trigger.fault;
  const std::uint8_t eventClass = !comesAndGoes(row, fault) ? 0x35 : trigger.going ? 0x38 : 0x39;
  StartInformation start =
      startInformation(eventClass, fault, priorityOf(row.ob), row.ob, cpu.log().dateAndTime());
  if (row.ob == 80) setDWord(start, 8, 0x11030101);  // as if OB 1 had caused it
  cpu.requests().asynchronousError(start);
}

}  // namespace

bool canTrigger(std::uint32_t ob) {
  return rowOf(kModuleRows, ob) != std::end(kModuleRows) ||
         rowOf(kErrorRows, ob) != std::end(kErrorRows);
}

void trigger(Cpu& cpu, const Trigger& event) {
  const auto module = rowOf(kModuleRows, event.ob);
  if (module != std::end(kModuleRows)) return moduleEvent(cpu, *module, event);
  const auto row = rowOf(kErrorRows, event.ob);
  if (row != std::end(kErrorRows)) error(cpu, *row, event);
}

}  // namespace merker::cpu
