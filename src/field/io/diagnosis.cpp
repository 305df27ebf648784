// Structure: manual "S7-300 Module data", appendix B; names as in the start information of OB 82.
#include "io/diagnosis.h"

#include <algorithm>
#include <iterator>

namespace merker::io {
namespace {

// byte 0
constexpr std::uint8_t kModuleDefect = 1, kInternal = 2, kExternal = 4, kChannel = 8,
                       kExternalVoltage = 16, kLine = 32, kParameters = 128;
// byte 1: module class, and that channel information follows
constexpr std::uint8_t kAnalogClass = 0x05, kFunctionClass = 0x08, kCommunicationClass = 0x0C,
                       kDigitalClass = 0x0F, kChannelInformation = 0x10;
// byte 2
constexpr std::uint8_t kCommunicationFault = 0x02;
// byte 3
constexpr std::uint8_t kConverter = 0x10, kFuse = 0x20, kInterruptLost = 0x40;

std::uint8_t classOf(const ModuleType& type) {
  switch (type.kind) {
    case ModuleKind::Digital:
      return kDigitalClass;
    case ModuleKind::Analog:
    case ModuleKind::Position:
      return kAnalogClass;
    case ModuleKind::Communication:
      return kCommunicationClass;
    case ModuleKind::PointToPoint:
      return 0;  // PTP-DIAG-09
    default:
      return kFunctionClass;
  }
}

// byte 4: channel type, and how many channels of it
struct ChannelType {
  std::uint8_t code, count;
};
ChannelType channelType(const ModuleType& type) {
  if (type.digitalInputs > 0) return {0x70, type.digitalInputs};
  if (type.analogInputs > 0) return {0x71, type.analogInputs};
  if (type.digitalOutputs > 0) return {0x72, type.digitalOutputs};
  return {0x73, type.analogOutputs};
}

struct ChannelBit {
  FaultKind kind;
  std::uint8_t bit;
};
constexpr ChannelBit kChannelBits[] = {{FaultKind::ShortCircuit, 3},
                                       {FaultKind::WireBreak, 4},
                                       {FaultKind::Underflow, 6},
                                       {FaultKind::Overflow, 7}};
// Faults of the whole module that show on each channel, by channel type.
struct CommonBit {
  FaultKind kind;
  std::uint8_t channelType, bit;
};
constexpr CommonBit kCommonBits[] = {{FaultKind::SensorSupply, 0x70, 6},
                                     {FaultKind::Fuse, 0x72, 5},
                                     {FaultKind::LoadVoltage, 0x72, 6},
                                     {FaultKind::LoadVoltage, 0x73, 6}};

std::uint8_t channelByte(const ModuleFaults& faults, std::uint32_t channel, std::uint8_t type) {
  unsigned byte = 0;
  for (const ChannelBit& row : kChannelBits)
    if (faults.has(channel, row.kind)) byte |= 1u << row.bit;
  for (const CommonBit& row : kCommonBits)
    if (row.channelType == type && faults.has(row.kind)) byte |= 1u << row.bit;
  return static_cast<std::uint8_t>(byte);
}

void appendChannels(std::vector<std::uint8_t>& record, const ModuleType& type,
                    const ModuleFaults& faults) {
  const ChannelType channels = channelType(type);
  constexpr std::uint8_t kBitsPerChannel = 8;
  for (const std::uint8_t byte : {channels.code, kBitsPerChannel, channels.count})
    record.push_back(byte);
  const std::size_t vector = record.size();
  record.resize(vector + (channels.count + 7u) / 8);
  for (std::uint32_t i = 0; i < channels.count; ++i) {
    const std::uint8_t byte = channelByte(faults, i, channels.code);
    if (byte != 0) {
      record[vector + i / 8] = static_cast<std::uint8_t>(record[vector + i / 8] | 1u << (i % 8));
      record[0] |= kModuleDefect | kExternal | kChannel;
    }
    record.push_back(byte);
  }
}

// Technology manual 3.6.3; the layout of the bytes before 8: POS-DIAG-07, -14.
void appendAxis(std::vector<std::uint8_t>& record, const ModuleFaults& faults) {
  constexpr std::uint8_t kAxisType = 0x74, kBits = 16, kChannels = 1, kParameterBit = 1;
  constexpr std::size_t kLength = 16;
  const bool parameters = faults.has(FaultKind::ParameterError);
  const std::uint16_t errors = faults.axis();
  const bool any = parameters || errors != 0;
  for (const std::uint8_t byte : {kAxisType, kBits, kChannels, std::uint8_t{any}})
    record.push_back(byte);
  record.push_back(static_cast<std::uint8_t>(errors));
  record.push_back(static_cast<std::uint8_t>(errors >> 8 | (parameters ? kParameterBit : 0)));
  record.resize(kLength);
  record[1] |= kChannelInformation;
  if (any) record[0] |= kModuleDefect | kChannel;
  if (errors != 0) record[0] |= kExternal;
}

}  // namespace

std::vector<std::uint8_t> diagnosis(const ModuleType& type, const ModuleFaults& faults) {
  std::vector<std::uint8_t> record(kRecord0);
  record[1] = classOf(type);
  const bool channels = type.kind == ModuleKind::Digital || type.kind == ModuleKind::Analog;
  if (channels) {
    record[1] |= kChannelInformation;
    appendChannels(record, type, faults);
  }
  if (type.kind == ModuleKind::Positioning) appendAxis(record, faults);
  if (faults.has(FaultKind::Defect)) {
    record[0] |= kModuleDefect | kInternal;
    if (type.kind == ModuleKind::Analog) record[3] |= kConverter;
  }
  if (faults.has(FaultKind::LoadVoltage)) record[0] |= kModuleDefect | kExternal | kExternalVoltage;
  if (faults.has(FaultKind::SensorSupply)) record[0] |= kModuleDefect | kExternal;
  if (faults.has(FaultKind::Fuse)) {
    record[0] |= kModuleDefect | kExternal;
    record[3] |= kFuse;
  }
  // technology manual 5.8.3 (CNT-DIAG-03, -04)
  if (faults.has(FaultKind::ParameterError)) record[0] |= kModuleDefect | kParameters;
  if (faults.has(FaultKind::InterruptLost)) {
    record[0] |= kModuleDefect;
    record[3] |= kInterruptLost;
  }
  // technology manual 6.7.4 (PTP-DIAG-07); bit 5 is the wire break here
  if (faults.has(FaultKind::LineBreak)) {
    record[0] |= kModuleDefect | kExternal | kLine;
    record[2] |= kCommunicationFault;
  }
  return record;
}

// Manual of the CP 343-2, 6.6: data record 1 has always 16 bytes. Three of them are fixed, then a
// bit for each slave, four bytes for addresses B, which nobody has here, and a reserved one.
void addMissingSlaves(std::vector<std::uint8_t>& record, std::uint32_t slaves) {
  constexpr std::uint8_t kFixed[] = {0x60, 0x00, 0x40};
  constexpr std::size_t kLength = 16;
  record[1] |= kChannelInformation;
  record.insert(record.end(), std::begin(kFixed), std::end(kFixed));
  for (unsigned shift = 0; shift < 32; shift += 8)
    record.push_back(static_cast<std::uint8_t>(slaves >> shift));
  record.resize(kLength);
  if (slaves != 0) record[0] |= kModuleDefect | kExternal | kChannel;
}

}  // namespace merker::io
