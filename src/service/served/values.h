// Ranges of bytes, timers and counters: in the copy of a PLC's operands, and in the PLC.
#pragma once

#include "monitor/monitor.h"
#include "plc/operand_memory.h"
#include "s7comm/plc.h"

namespace merker::served {

// Only the PLC itself can read the periphery.
constexpr bool isCopied(const s7comm::Range& range) {
  return range.memory != s7comm::Memory::Peripheral;
}

s7comm::Value valueOf(const controller::OperandImage& image, const s7comm::Range& range);
// In the PLC's thread. PE.
s7comm::Value peripheralValue(const controller::Controller& plc, const s7comm::Range& range);
// Each range, of the copy or of the PLC.
std::vector<s7comm::Value> valuesNow(const controller::Controller& plc,
                                     const std::vector<s7comm::Range>& ranges);
// All of it or nothing. Inputs: at the terminals; where no module has any, in the process image.
s7comm::ItemCode put(monitor::Monitor& monitor, const s7comm::Write& write);
// The same at a point of the cycle: inputs in the process image. What is forced stays.
s7comm::ItemCode putInCycle(monitor::Monitor& monitor, const s7comm::Write& write);
// Until they are let go; all of it or nothing.
bool force(monitor::Monitor& monitor, const std::vector<s7comm::Write>& writes);

}  // namespace merker::served
