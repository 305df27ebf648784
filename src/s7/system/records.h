// Exchanging data records with a module: what SFC 54 … 59 and SFB 52, 53 have in common.
#pragma once

#include <cstdint>
#include <vector>

#include "system/call.h"
#include "system/module_access.h"

namespace merker::system {

constexpr std::uint32_t kUnknownAddress = 0x8090, kNotByte = 0x8092, kNotAllowed = 0x8093;
constexpr std::uint32_t kNotRead = 0x80A0, kUnknownRecord = 0x80B0, kWrongLength = 0x80B1;
constexpr std::uint32_t kTooManyJobs = 0x80C3, kNoParameters = 0x80D0, kNoSuchParameters = 0x80D1;
constexpr std::uint32_t kHighestRecord = 240;

// What is asked for. `code` 0, or why it is refused.
struct RecordTarget {
  ModuleInfo module;
  std::uint32_t number = 0;
  std::uint32_t code = 0;
  Job job;
};
RecordTarget recordTarget(Arguments& a, std::uint32_t area, std::uint32_t address,
                          std::uint32_t number);
// Of SFC 54 to 59, whose rows have IOID and LADDR.
template <typename A>
RecordTarget recordTarget(A& a, std::uint32_t number) {
  return recordTarget(a, a.value("IOID"), a.value("LADDR"), number);
}

// 0 when the job has come to its end, else 7000, 7001 or why it cannot begin.
std::uint32_t proceed(Arguments& a, const RecordTarget& target, bool request);

std::uint32_t readFrom(Arguments& a, const RecordTarget& target, std::vector<std::uint8_t>& data);
std::uint32_t writeTo(Arguments& a, const RecordTarget& target,
                      const std::vector<std::uint8_t>& data);

// The bytes of a RECORD, or the code that says why there are none.
std::uint32_t recordBytes(Arguments& a, const AnyPointer& where, std::vector<std::uint8_t>& data);

}  // namespace merker::system
