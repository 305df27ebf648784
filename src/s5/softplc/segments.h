// The address space of LIR, TIR, TNB, TNW and of the programmer: segment number and byte offset
// (S5-SYS-T1, S5-MEM-T1). Words have even offsets, the high byte first.
#pragma once

#include <cstdint>
#include <optional>

#include "softplc/machine.h"

namespace merker::sinumerik {

// Bytes of segment 1 where its parts begin (docs/compatibility.md: own arrangement).
namespace segment1 {
constexpr std::uint32_t kInputs = 0x0000, kOutputs = 0x0080, kFlags = 0x0100, kTimers = 0x0200,
                        kCounters = 0x0240;
constexpr std::uint32_t kObList = 0x1000, kFbList = 0x1100, kDbList = 0x1500, kSbList = 0x1900,
                        kPbList = 0x1D00, kEnd = 0x2C00;
}  // namespace segment1

bool readable(std::uint32_t segment);  // 1..10
bool writable(std::uint32_t segment);  // 1..6

// Nothing where there is no memory.
std::optional<std::uint8_t> readByte(const Machine& m, std::uint32_t segment, std::uint32_t offset);
bool writeByte(Machine& m, std::uint32_t segment, std::uint32_t offset, std::uint8_t value);
std::optional<std::uint16_t> readWord(const Machine& m, std::uint32_t segment,
                                      std::uint32_t offset);
bool writeWord(Machine& m, std::uint32_t segment, std::uint32_t offset, std::uint16_t value);

}  // namespace merker::sinumerik
