// Machine data that the PLC reads: words 0..9, user words 1000..1007, bits 2000..2010, and MD 155
// of the NC (S5-MD, 7.2, 7.3).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "softplc/alarm.h"

namespace merker::sinumerik {

struct WordRow {
  unsigned number;
  std::string_view meaning;
  std::uint16_t standard, highest;
  std::string_view unit;
  std::optional<Alarm> alarm;  // at start-up, if the word is beyond `highest`
};
std::span<const WordRow> wordRows();

// A bit of MD 2000..2003.
struct DataBit {
  unsigned number, bit;
};
namespace data_bit {
constexpr DataBit kNoAlarmLevel{2002, 0}, kControlPanelToOutputs{2002, 3}, kDistributed{2002, 4};
constexpr DataBit kStopOnUnit{2003, 2}, kWarmRestart{2003, 3}, kChopping{2003, 6},
    kDiagnosis{2003, 7};
}  // namespace data_bit

// Where the bits for the run times and the system commands stand: the manual's table 7.3 and its
// text 1.3.4, 9.4.13 contradict each other (OP-09).
enum class BitMapping : std::uint8_t { Table, Text };

class MachineData {
 public:
  MachineData();  // standard values
  // Standard values; without OB 2 in the program the alarm level is switched off, since the PLC
  // would stop (S5-OB-09).
  static MachineData standard(bool withAlarmLevel);

  // Words 0..9 and 1000..1007; 0 for a number that does not exist.
  std::uint16_t word(unsigned number) const;
  bool setWord(unsigned number, std::uint16_t value);
  // User word as the program gets it: binary, or BCD if its bit in MD 2000 says so (S5-MD-07).
  std::uint16_t userValue(unsigned number) const;
  bool bit(DataBit bit) const;
  bool setBit(DataBit bit, bool on);  // false: no such bit
  std::uint8_t byte(unsigned number) const;

  std::uint8_t samplingCode = 2;  // MD 155 of the NC, 0..5
  BitMapping mapping = BitMapping::Table;
  bool stops(Reaction reaction) const;
  bool systemCommands() const;

  // The first word beyond its limit or an illegal MD 155 (6116 … 6123).
  std::optional<Alarm> illegal() const;

 private:
  std::array<std::uint16_t, 10> words_{};
  std::array<std::uint16_t, 8> user_{};   // 1000..1007
  std::array<std::uint8_t, 11> bytes_{};  // 2000..2010
};

}  // namespace merker::sinumerik
