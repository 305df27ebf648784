// Data blocks that the operating system creates at start-up, and DB 1 among them: run times and
// fault bits (S5-DB-10, S5-SCHED-14, S5-ERR-02).
#pragma once

#include <cstdint>

#include "softplc/alarm.h"
#include "softplc/block_memory.h"
#include "softplc/run_times.h"

namespace merker::sinumerik {

// Words of segment 6 that user blocks may take, and those kept for the system's (S5-MEM-08).
constexpr std::uint32_t kUserDataWords = 3072, kSystemDataWords = 154;

struct SystemOptions {
  bool softwareCams = false;  // DB 39
  bool adarCoupling = false;  // DB 71
};

bool isSystemBlock(std::uint16_t db, const SystemOptions& options);
// False: one finds no room.
bool createSystemBlocks(BlockMemory& blocks, const SystemOptions& options);

// Words of DB 1 (S5-SCHED-14; DW 4: OP-10).
namespace diagnosis {
constexpr std::uint16_t kDb = 1;
constexpr std::uint32_t kCycleTime = 0, kRunTime = 1, kCyclicTime = 2, kAlarmTime = 3,
                        kAlarmRuns = 4, kFaults = 8, kTrigger = 9;
constexpr std::uint16_t kTriggerBit = 0x8000;  // D 9.15
// Sets the bit of DW 8 that belongs to the alarm; false if it has none.
bool showFault(BlockMemory& blocks, Alarm alarm);
// The values of the cycle that has just ended, if D 9.15 asks for them.
void showTimes(BlockMemory& blocks, Duration cycleTime, const CycleTimes& times);
}  // namespace diagnosis

}  // namespace merker::sinumerik
