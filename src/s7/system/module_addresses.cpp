// SFC 5 GADR_LGC, 49 LGC_GADR, 50 RD_LGADR (S7-SFC-04): places and addresses of modules.
#include "base/bytes.h"
#include "system/call.h"
#include "system/module_access.h"
#include "system/records.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kHighestSlot = 11, kCpuSlot = 2, kHighestSubslot = 5;

// 0, or which part of the place cannot be.
std::uint32_t placeError(const CpuModel& model, std::uint32_t subnet, std::uint32_t rack,
                         std::uint32_t slot, std::uint32_t subslot) {
  constexpr std::uint32_t kSubnet = 0x8094, kRack = 0x8095, kSlot = 0x8096, kSubslot = 0x8097;
  if (subnet != 0) return kSubnet;
  if (rack >= model.racks) return kRack;
  if (slot == 0 || slot > kHighestSlot) return kSlot;
  if (subslot > kHighestSubslot || (subslot != 0 && slot != kCpuSlot)) return kSubslot;
  return 0;
}

struct WordField {
  Sfc<50>::Name place, count;
  std::uint32_t wrongType, tooShort;
};

// The addresses of a range, byte by byte, into a field of words.
bool storeAddresses(Sfc<50>& a, const WordField& field, const AddressRange& range) {
  const AnyPointer where = a.any(field.place);
  if (where.type != TypeCode::Word) return a.status(field.wrongType), false;
  if (where.count < range.count) return a.status(field.tooShort), false;
  const Region region = a.region(where, 2u * range.count, cpu::Access::Write);
  if (!region) return a.parameterError(field.place, region.error), false;
  for (std::uint32_t i = 0; i < range.count; ++i) storeWord(region.data + 2 * i, range.first + i);
  a.set(field.count, range.count);
  return true;
}

}  // namespace

void addressOfSlot(Sfc<5>& a) {
  constexpr std::uint32_t kNotConfigured = 0x8099, kNoSubaddress = 0x809A;
  const std::uint32_t rack = a.value("RACK"), slot = a.value("SLOT"), subslot = a.value("SUBSLOT");
  a.set("IOID", 0);
  a.set("LADDR", 0);
  if (const auto error = placeError(*a.machine().model, a.value("SUBNETID"), rack, slot, subslot))
    return a.status(error);
  const auto module =
      moduleIn(a.modules(), {static_cast<std::uint8_t>(rack), static_cast<std::uint8_t>(slot),
                             static_cast<std::uint8_t>(subslot)});
  if (!module) return a.status(kNotConfigured);
  const ModuleBase base = baseOf(*module);
  const AddressRange& range = base.area == kInputArea ? module->inputs : module->outputs;
  const std::uint32_t address = base.address + a.value("SUBADDR");
  if (!range.contains(address)) return a.status(kNoSubaddress);
  a.set("IOID", base.area);
  a.set("LADDR", address);
  a.status(0);
}

void slotOfAddress(Sfc<49>& a) {
  constexpr std::uint32_t kS7300 = 1;
  const std::uint32_t area = a.value("IOID"), address = a.value("LADDR");
  const auto module = moduleAt(a.modules(), area, address, AddressRule::Any);
  if (!module) return a.status(kUnknownAddress);
  a.set("AREA", kS7300);
  a.set("RACK", module->place.rack);
  a.set("SLOT", module->place.slot);
  a.set("SUBADDR", address - (area == kInputArea ? module->inputs : module->outputs).first);
  a.status(0);
}

void addressesOfModule(Sfc<50>& a) {
  const auto module = moduleAt(a.modules(), a.value("IOID"), a.value("LADDR"), AddressRule::Any);
  if (!module) return a.status(kUnknownAddress);
  if (storeAddresses(a, {"PEADDR", "PECOUNT", 0x80A0, 0x80A2}, module->inputs) &&
      storeAddresses(a, {"PAADDR", "PACOUNT", 0x80A1, 0x80A3}, module->outputs))
    a.status(0);
}

}  // namespace merker::system
