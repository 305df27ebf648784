// CPU models as constant rows: every limit stands here, none in code (S7-CPU-01).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "address/block_id.h"

namespace merker {

// Classes of execution time that the course gives for a CPU (2.1): bit, word, fixed point, floating
// point.
enum class TimeClass : std::uint8_t { None, Bit, Word, Fixed, Real };

// Inputs, outputs and technological channels that a compact CPU brings in slot 2 (S7-CPU-15 to
// -18).
struct OnBoard {
  std::uint8_t digitalInputs = 0, digitalOutputs = 0;
  std::uint8_t analogInputs = 0, analogOutputs = 0;  // the fifth analog input is the one for Pt100
  std::uint8_t counters = 0, positioning = 0;
  // default start addresses of E and A, PEW and PAW, counting, positioning
  std::uint16_t digital = 0, analog = 0, counting = 0, positions = 0;
  bool serial = false, computerLink = false;  // X27 (PTP-OVW-01), with RK 512
  bool operator==(const OnBoard&) const = default;
};

struct CpuModel {
  std::string_view name;  // "CPU 314C-2 PtP"
  std::string_view
      keyword;  // "314C-2 PtP", what --cpu takes (ignoring case, blanks and a leading CPU)
  std::string_view orderNumber;             // "6ES7 314-6BF01-0AB0"; empty: nobody sells it
  std::uint8_t firmware[3] = {};            // V2.0.0
  std::span<const std::uint8_t> lacksSfcs;  // system functions that this CPU does not have
  std::span<const std::uint8_t> lacksSfbs;

  // nanoseconds per instruction
  std::uint32_t bitTime, wordTime, fixedTime, realTime;
  // nanoseconds the operating system needs per cycle (checkpoint and process image)
  std::uint32_t cycleTime;

  // bytes
  std::uint32_t workMemory, blockSize, dataBlockSize;
  std::uint32_t flagBytes, imageBytes, peripheralBytes, localBytes;
  std::uint32_t timers, counters;
  std::uint32_t runtimeMeters;
  // highest block numbers; -1 = none of the kind
  std::int32_t highestDb, highestFb, highestFc;
  std::uint32_t nesting;       // blocks per priority class
  std::uint32_t errorNesting;  // further blocks inside a synchronous error OB
  std::uint32_t bracketDepth, mcrDepth;
  std::uint32_t accumulators;                                        // 2 or 4
  std::uint32_t cycleMonitoring;                                     // ms, default
  std::uint32_t retentiveFlags, retentiveTimers, retentiveCounters;  // default counts from number 0
  bool hotRestart, coldRestart;
  bool allPeripheral;  // every periphery byte answers, no module needed (generic)
  // hardware (S7-CPU-11 to -18)
  std::uint32_t racks;                            // highest number + 1
  std::uint32_t digitalChannels, analogChannels;  // with those on board (S7-OPEN-45)
  std::uint32_t busCurrent;                       // mA that modules may take in rack 0 (S7-HW-14)
  std::uint32_t loadMemory;                       // bytes: built in, or the largest memory card
  OnBoard onBoard;
  std::span<const std::uint8_t> organizationBlocks;

  std::uint32_t time(TimeClass c) const {
    switch (c) {
      case TimeClass::Bit:
        return bitTime;
      case TimeClass::Word:
        return wordTime;
      case TimeClass::Fixed:
        return fixedTime;
      case TimeClass::Real:
        return realTime;
      case TimeClass::None:
        return 0;
    }
    return 0;
  }
  bool hasOrganizationBlock(unsigned number) const;
  // Whether a block of this number can exist; OBs by the list above. SFC and SFB: always (system
  // decides).
  bool allows(BlockId id) const;
};

std::span<const CpuModel> cpuModels();
const CpuModel& defaultCpuModel();                    // CPU 314C-2 PtP
const CpuModel* findCpuModel(std::string_view name);  // null if unknown

}  // namespace merker
