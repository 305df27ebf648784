// Libraries of STEP 7 whose blocks a program may call without having them: as a user would copy
// them into the project (docs/compatibility.md, "Libraries").
#pragma once

#include <cstdint>
#include <vector>

namespace merker {

enum class BlockLibrary : std::uint8_t {
  Cpu,       // no library: SFC and SFB of the CPU
  Standard,  // "Standard Library": IEC functions and TI-S7 converting blocks
  NetCp      // "SIMATIC_NET_CP": AG_SEND, AG_RECV and the blocks for S7 connections of a CP 343-1
};

// In this order: a number that several have is that of the first one.
using Libraries = std::vector<BlockLibrary>;
inline const Libraries& standardLibraries() {
  static const Libraries kStandard = {BlockLibrary::Standard};
  return kStandard;
}

}  // namespace merker
