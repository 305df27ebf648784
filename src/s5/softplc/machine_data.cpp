#include "softplc/machine_data.h"

#include "base/bcd.h"

namespace merker::sinumerik {
namespace {

constexpr WordRow kWords[] = {
    {0, "number of the input byte for alarms", 7, 31, "", Alarm::AlarmByteNumber},
    {1, "load of the processor by OB 1 and OB 2", 15, 20, "%", Alarm::LoadNumber},
    {2, "call of OB 1 (ACOP)", 0, 3, "IPO clock", std::nullopt},
    {3, "run time of the alarm level", 2000, 2500, "µs", Alarm::AlarmTimeNumber},
    {5, "cycle time monitoring", 70, 320, "ms", Alarm::CycleTimeNumber},
    {6, "number of the last active timer", 15, 31, "", Alarm::LastTimerNumber},
    {8, "interface for DB 37", 1, 2, "", std::nullopt},
    {9, "extension of the data block memory", 8, 32, "kbyte", std::nullopt}};

constexpr unsigned kUser = 1000, kUserWords = 8, kBits = 2000, kBitBytes = 11;
constexpr std::uint8_t kHighestSamplingCode = 5;
// Standard of MD 2003: a run time beyond its limit stops the PLC (S5-MD-04).
constexpr std::uint8_t kStopOnRunTimes = 0x03;

}  // namespace

std::span<const WordRow> wordRows() { return kWords; }

MachineData::MachineData() {
  for (const WordRow& row : kWords) words_[row.number] = row.standard;
  bytes_[3] = kStopOnRunTimes;
}

MachineData MachineData::standard(bool withAlarmLevel) {
  MachineData data;
  data.setBit(data_bit::kNoAlarmLevel, !withAlarmLevel);
  return data;
}

std::uint16_t MachineData::word(unsigned number) const {
  if (number < words_.size()) return words_[number];
  return number - kUser < kUserWords ? user_[number - kUser] : std::uint16_t{0};
}

bool MachineData::setWord(unsigned number, std::uint16_t value) {
  if (number - kUser < kUserWords) {
    user_[number - kUser] = value;
    return true;
  }
  for (const WordRow& row : kWords) {
    if (row.number != number) continue;
    words_[number] = value;
    return true;
  }
  return false;
}

std::uint16_t MachineData::userValue(unsigned number) const {
  const std::uint16_t value = word(number);
  return bit({kBits, number - kUser}) ? static_cast<std::uint16_t>(toBcd(value, 4)) : value;
}

std::uint8_t MachineData::byte(unsigned number) const {
  return number - kBits < kBitBytes ? bytes_[number - kBits] : std::uint8_t{0};
}

bool MachineData::bit(DataBit b) const { return b.bit < 8 && (byte(b.number) >> b.bit & 1) != 0; }

bool MachineData::setBit(DataBit b, bool on) {
  if (b.number - kBits >= kBitBytes || b.bit > 7) return false;
  std::uint8_t& byte = bytes_[b.number - kBits];
  const auto mask = static_cast<std::uint8_t>(1u << b.bit);
  byte = static_cast<std::uint8_t>(on ? byte | mask : byte & ~mask);
  return true;
}

bool MachineData::stops(Reaction reaction) const {
  switch (reaction) {
    case Reaction::Message:
      return false;
    case Reaction::Stop:
      return true;
    case Reaction::StopIfOb1:
      return bit({2003, mapping == BitMapping::Table ? 1u : 0u});
    case Reaction::StopIfOb2:
      return bit({2003, mapping == BitMapping::Table ? 0u : 1u});
    case Reaction::StopIfUnit:
      return bit(data_bit::kStopOnUnit);
  }
  return true;
}
bool MachineData::systemCommands() const {
  return bit({2003, mapping == BitMapping::Table ? 4u : 5u});
}

std::optional<Alarm> MachineData::illegal() const {
  for (const WordRow& row : kWords)
    if (row.alarm && words_[row.number] > row.highest) return row.alarm;
  if (samplingCode > kHighestSamplingCode) return Alarm::SamplingTime;
  return std::nullopt;
}

}  // namespace merker::sinumerik
