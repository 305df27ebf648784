// Access to any operand by area and bit address, as pointers name it. For everything that is not
// known before it runs: indirect addressing, parameters, system functions, the outside.
#pragma once

#include <cstdint>

#include "cpu/error.h"
#include "cpu/machine.h"

namespace merker::cpu {

struct Located {
  std::uint8_t* bytes = nullptr;  // null when there is an error
  std::uint8_t mask = 0;          // of the bit
  SyncError error{};
};

enum class Access : std::uint8_t { Read, Write };

// Where the operand lies; E, A, M, DB, DI, L, V. Periphery has no place in memory: use read and
// write.
Located locate(Machine& m, Area area, Width width, BitAddress address, Access access);

SyncError read(Machine& m, Area area, Width width, BitAddress address, std::uint32_t& value);
SyncError write(Machine& m, Area area, Width width, BitAddress address, std::uint32_t value);

// Local data of a block are about to be accessed: notes it if they are the date and time that OB 1
// was handed over.
void lookAtLocal(Machine& m, const Frame& frame, std::uint32_t first, std::uint32_t bytes);

std::uint32_t loadBytes(const std::uint8_t* bytes, Width width);
void storeBytes(std::uint8_t* bytes, Width width, std::uint32_t value);

}  // namespace merker::cpu
