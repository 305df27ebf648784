#include "system/variable_server.h"

#include <algorithm>

#include "system/arguments.h"

namespace merker::system {
namespace {

using cpu::ErrorCode;
using s7comm::ItemCode;
using s7comm::Memory;

ItemCode itemCodeOf(ErrorCode error) {
  switch (error) {
    case ErrorCode::None:
      return ItemCode::Done;
    case ErrorCode::DbMissing:
      return ItemCode::Missing;
    case ErrorCode::ProtectedDb:
      return ItemCode::AccessDenied;
    default:
      return ItemCode::OutOfRange;
  }
}

// E, A, M and data blocks; timers and counters have no place in ADDR_i of a GET, the periphery none
// in a process image.
bool isServed(const s7comm::Range& range) {
  return !s7comm::isCell(range.memory) && range.memory != Memory::Peripheral;
}

Region servedRegion(cpu::Cpu& cpu, const s7comm::Range& range, cpu::Access access) {
  const std::uint32_t start = pointer(static_cast<Area>(range.memory), bitAddress(range.begin));
  return regionOf(
      cpu.machine(),
      {.type = TypeCode::Byte, .count = range.octets, .db = range.block, .pointer = start},
      range.octets, access);
}

s7comm::Value readServed(cpu::Cpu& cpu, const s7comm::Range& range) {
  if (!isServed(range)) return {ItemCode::TypeNotSupported, {}};
  const Region region = servedRegion(cpu, range, cpu::Access::Read);
  if (!region) return {itemCodeOf(region.error), {}};
  if (range.oneBit)
    return {ItemCode::Done, {static_cast<std::uint8_t>(*region.data >> range.bit & 1)}};
  return {ItemCode::Done, {region.data, region.data + region.length}};
}

ItemCode writeServed(cpu::Cpu& cpu, const s7comm::Write& write) {
  if (!isServed(write.range)) return ItemCode::TypeNotSupported;
  const Region region = servedRegion(cpu, write.range, cpu::Access::Write);
  if (!region) return itemCodeOf(region.error);
  if (!write.range.oneBit) {
    std::ranges::copy(write.octets, region.data);
    return ItemCode::Done;
  }
  const auto mask = static_cast<std::uint8_t>(1u << write.range.bit);
  *region.data = static_cast<std::uint8_t>((write.octets[0] & 1) != 0 ? *region.data | mask
                                                                      : *region.data & ~mask);
  return ItemCode::Done;
}

}  // namespace

void VariableServer::read(const std::vector<s7comm::Range>& ranges, ReadDone done) {
  std::vector<s7comm::Value> values;
  for (const s7comm::Range& range : ranges) values.push_back(readServed(cpu_, range));
  done(std::move(values));
}

void VariableServer::write(std::vector<s7comm::Write> writes, WriteDone done) {
  std::vector<ItemCode> codes;
  for (const s7comm::Write& one : writes) codes.push_back(writeServed(cpu_, one));
  done(std::move(codes));
}

}  // namespace merker::system
