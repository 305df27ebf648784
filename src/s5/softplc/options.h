// Everything a PLC is built from (arguments of sinumerik::Plc).
#pragma once

#include <bitset>
#include <optional>

#include "mc5/block.h"
#include "softplc/engine.h"
#include "softplc/machine_data.h"
#include "softplc/processor.h"
#include "softplc/raster.h"
#include "softplc/surroundings.h"
#include "softplc/system_blocks.h"
#include "softplc/user_alarms.h"

namespace merker::sinumerik {

// The DB by which the basic program decodes M, S, T, H functions: checked only (6143 … 6146).
struct DecodingDb {
  std::uint16_t number = 0;
  unsigned units = 1;  // of 6 words each
};

// Bytes of the machine control panel, copied from the input to the output image if MD 2002 bit 3
// says so (S5-MD-06).
struct ControlPanel {
  unsigned input = 112, output = 112, bytes = 8;
};

struct Options {
  mc5::Program program{};
  mc5::Variant variant = mc5::Variant::Acop;
  Software software = Software::Sw2;         // COP is always SW 1 (S5-OPC-07)
  std::optional<MachineData> machineData{};  // without: standard, OB 2 allowed if there is one
  bool memoryExtension = false;              // option; from SW 2 on
  SystemOptions systemBlocks{};
  std::bitset<256> dataInEprom{};  // user data blocks that nobody can write
  UserAlarms userAlarms{};
  std::optional<DecodingDb> decodingDb{};
  ControlPanel controlPanel{};
  Surroundings surroundings{};
  bool coverage = false;     // count how often each instruction runs
  Macros* macros = nullptr;  // resident function macros; must outlive the PLC
  Engine* engine = nullptr;  // machine code of this computer; must outlive the PLC
};

}  // namespace merker::sinumerik
