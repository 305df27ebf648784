#include "monitor/assignment_list.h"

#include <map>
#include <set>

namespace merker::monitor {
namespace {

using Bytes = std::map<std::pair<Area, std::uint32_t>, AssignmentByte>;

// A range (ANY, composite parameter) counts byte by byte.
void add(Bytes& bytes, const CrossReference& row) {
  const address::Operand& operand = row.key;
  const std::uint32_t first = operand.value / 8;
  const std::uint32_t last = (operand.value + row.bits + 7) / 8;
  const std::uint32_t count = row.bits != 0 ? last - first : byteCount(operand.width);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t number = operand.value / 8 + i;
    AssignmentByte& byte = bytes[{operand.area, number}];
    byte.area = operand.area;
    byte.byte = number;
    if (operand.width == Width::Bit) byte.bits[operand.value & 7] = true;
    byte.byByte |= operand.width == Width::Byte;
    byte.byWord |= operand.width == Width::Word;
    byte.byDWord |= operand.width == Width::DWord;
  }
}

}  // namespace

AssignmentList assignmentList(const std::vector<CrossReference>& list) {
  Bytes bytes;
  std::set<std::uint32_t> timers, counters;
  for (const CrossReference& row : list) {
    const address::Operand& key = row.key;
    if (isTimer(key)) timers.insert(key.value);
    if (isCounter(key)) counters.insert(key.value);
    const bool image =
        key.area == Area::Input || key.area == Area::Output || key.area == Area::Flag;
    if (isMemory(key) && image) add(bytes, row);
  }
  AssignmentList result;
  for (const auto& [place, byte] : bytes) result.bytes.push_back(byte);
  result.timers.assign(timers.begin(), timers.end());
  result.counters.assign(counters.begin(), counters.end());
  return result;
}

}  // namespace merker::monitor
