#include "system/partner_memory.h"

#include <algorithm>

namespace merker::system {
namespace {

using s7comm::PartnerStatus;

bool isSendable(const AnyPointer& where) {
  const bool type = isElementary(where.type) || where.type == TypeCode::DateAndTime;
  const bool oneBit = where.type != TypeCode::Bool || where.count == 1;
  return where.syntax == AnyPointer{}.syntax && type && oneBit && where.count > 0;
}

// The bytes that hold it; a bit lies in one.
Region regionOf(Arguments& a, const AnyPointer& where, cpu::Access access) {
  AnyPointer bytes = where;
  if (where.type == TypeCode::Bool) bytes.pointer &= ~7u;
  return a.region(bytes, byteCount(where), access);
}

// The one type that has another code there.
s7comm::ElementType elementOf(const AnyPointer& where) {
  return where.type == TypeCode::DateAndTime ? s7comm::ElementType::DateAndTime
                                             : static_cast<s7comm::ElementType>(where.type);
}

unsigned bitOf(const AnyPointer& where) { return where.pointer & 7; }

}  // namespace

Taken takeValue(Arguments& a, const AnyPointer& where) {
  if (!isSendable(where)) return {PartnerStatus::WrongLength};
  const Region region = regionOf(a, where, cpu::Access::Read);
  if (!region) return {PartnerStatus::NoMemory};
  Taken taken{.octets = {region.data, region.data + region.length}};
  if (where.type == TypeCode::Bool) taken.octets[0] = taken.octets[0] >> bitOf(where) & 1;
  return taken;
}

PartnerStatus receivableAt(Arguments& a, const AnyPointer& where) {
  if (!isSendable(where)) return PartnerStatus::WrongLength;
  return regionOf(a, where, cpu::Access::Write) ? PartnerStatus::Done : PartnerStatus::NoMemory;
}

PartnerStatus storeValue(Arguments& a, const AnyPointer& where, s7comm::View octets, bool exact) {
  if (!isSendable(where) || octets.size() > byteCount(where) ||
      (exact && octets.size() != byteCount(where)))
    return PartnerStatus::WrongLength;
  const Region region = regionOf(a, where, cpu::Access::Write);
  if (!region) return PartnerStatus::NoMemory;
  if (where.type != TypeCode::Bool) {
    std::ranges::copy(octets, region.data);
    return PartnerStatus::Done;
  }
  const auto mask = static_cast<std::uint8_t>(1u << bitOf(where));
  *region.data =
      static_cast<std::uint8_t>(octets[0] != 0 ? *region.data | mask : *region.data & ~mask);
  return PartnerStatus::Done;
}

s7comm::DataUnit unitOf(const AnyPointer& where) {
  const auto* const row = s7comm::findElement(static_cast<std::uint8_t>(elementOf(where)));
  return row == nullptr ? s7comm::DataUnit::None : row->answer;
}

std::optional<s7comm::AnyItem> itemOf(const AnyPointer& where) {
  const Area area = pointerArea(where.pointer);
  const bool image = area == Area::Input || area == Area::Output || area == Area::Flag;
  const bool block = area == Area::DataBlock && where.db != 0;
  if (!isSendable(where) || !(image || block)) return std::nullopt;
  return s7comm::AnyItem{.type = elementOf(where),
                         .count = static_cast<std::uint16_t>(where.count),
                         .block = where.db,
                         .memory = static_cast<s7comm::Memory>(area),
                         .address = where.pointer & 0xFF'FFFF};
}

}  // namespace merker::system
