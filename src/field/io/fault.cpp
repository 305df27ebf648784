#include "io/fault.h"

#include <array>

#include "base/text.h"
#include "io/asi.h"
#include "io/slave.h"

namespace merker::io {
namespace {

constexpr std::array kFaults{FaultName{"wire break", FaultKind::WireBreak, true},
                             FaultName{"short circuit", FaultKind::ShortCircuit, true},
                             FaultName{"overflow", FaultKind::Overflow, true},
                             FaultName{"underflow", FaultKind::Underflow, true},
                             FaultName{"load voltage", FaultKind::LoadVoltage, false},
                             FaultName{"sensor supply", FaultKind::SensorSupply, false},
                             FaultName{"fuse", FaultKind::Fuse, false},
                             FaultName{"defect", FaultKind::Defect, false},
                             FaultName{"removed", FaultKind::Removed, false},
                             FaultName{"power", FaultKind::RackPower, false},
                             FaultName{"parameter error", FaultKind::ParameterError, false},
                             FaultName{"interrupt lost", FaultKind::InterruptLost, false},
                             FaultName{"line break", FaultKind::LineBreak, false}};

}  // namespace

const FaultName* findFault(std::string_view words) {
  for (const FaultName& row : kFaults)
    if (equalsIgnoreCase(row.words, words)) return &row;
  return nullptr;
}

const FaultName& nameOf(FaultKind kind) { return kFaults[static_cast<std::size_t>(kind)]; }

std::string faultNames() {
  std::string list;
  for (const FaultName& row : kFaults) {
    if (!list.empty()) list += ", ";
    list += row.words;
  }
  return list;
}

bool possible(const ModuleType& type, FaultKind kind) {
  if (isHead(type))
    return kind == FaultKind::RackPower || kind == FaultKind::LineBreak ||
           kind == FaultKind::ShortCircuit;
  const bool signals = type.kind == ModuleKind::Digital || type.kind == ModuleKind::Analog;
  const bool plugged = !type.orderNumber.empty() && type.signalModule();
  switch (kind) {
    case FaultKind::WireBreak:
      return type.kind == ModuleKind::Analog ||
             (type.digitalOutputs > 0 && type.diagnosticInterrupt);
    case FaultKind::ShortCircuit:
      return signals && type.hasOutputs();
    case FaultKind::Overflow:
    case FaultKind::Underflow:
      return type.analogInputs > 0;
    case FaultKind::LoadVoltage:
      return signals || type.kind == ModuleKind::Position || isAsiMaster(type);
    case FaultKind::SensorSupply:
      return type.digitalInputs > 0;
    case FaultKind::Fuse:
      return type.digitalOutputs > 0;
    case FaultKind::Defect:
    case FaultKind::Removed:
      return plugged;
    case FaultKind::RackPower:
      return type.kind == ModuleKind::Interface;
    case FaultKind::ParameterError:
      return type.kind == ModuleKind::Counting || type.kind == ModuleKind::Positioning;
    case FaultKind::InterruptLost:
      return type.kind == ModuleKind::Counting;
    case FaultKind::LineBreak:
      return type.kind == ModuleKind::PointToPoint;
  }
  return false;
}

}  // namespace merker::io
