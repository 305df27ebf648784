#include "nc/data_type.h"

#include "nc/data_access.h"

namespace merker::nc {
namespace {

using namespace access;

constexpr FormatSet kNone = 0, kBits = only(Format::BI), kStored = only(Format::BG);
constexpr FormatSet kBcd = from(Format::B0, Format::B9), kFixed = from(Format::F0, Format::F9);
constexpr FormatSet kCounts = only(Format::B0) | only(Format::F0);
constexpr FormatSet kNumbers = kBcd | kFixed;
constexpr FormatSet kTool = kNumbers | kStored | kBits;
constexpr FormatSet kParameter = kBcd | from(Format::F0, Format::FF) | kStored | kBits;
constexpr FormatSet kActual = kBcd | kStored | only(Format::F0);
constexpr FormatSet kPresetWrite = kBcd | kStored | only(Format::F4);  // as printed (OP-14)
constexpr FormatSet kThousandths = only(Format::B4) | only(Format::F4);

constexpr Limit kWords{0, 4999}, kBytes{5000, 9999};
constexpr Limit kTool1{1, kTools}, kTurningValues{0, 9}, kGrindingValues{0, kToolValues - 1};
constexpr Limit kGroups{1, kSettableGroups}, kG58{1, kProgrammableGroups}, kAxis{1, kAxes};
constexpr Limit kFlag{0, 1}, kZero{0, 0}, kChannel{1, kChannels}, kLevel{0, kLevels - 1};
constexpr Limit kR{0, kChannelParameters - 1}, kCentralR{900, 999};
constexpr auto kWhole = Content::Whole;
constexpr auto kPosition = Content::Position;
constexpr auto kFloating = Content::Floating;
constexpr auto kByte = Content::Bits;
constexpr auto kGrinding = DataType::On::Grinding;
constexpr auto kOthers = DataType::On::Others;

// name, WER1 … WER3, formats FB 61, formats FB 62, largest ANZ, which WER counts, values each
// clang-format off
constexpr std::array kTypes{
    DataType{"MDN", {kWords}, kCounts, kCounts, 80, 1, 1, kWhole, machineData, setMachineData},
    DataType{"MDNBY", {kBytes}, kBits, kBits, 80, 1, 1, kByte, machineDataByte, setMachineDataByte},
    DataType{"SEN", {kWords}, kCounts, kCounts, 80, 1, 1, kWhole, settingData, setSettingData},
    DataType{"SENBY", {kBytes}, kBits, kBits, 30, 1, 1, kByte, settingDataByte, setSettingDataByte},
    DataType{"TOS", {kZero, kTool1, kTurningValues}, kTool, kTool, 10, 3, 1, kFloating, toolOffset, setToolOffset, kOthers},
    DataType{"TOS", {kZero, kTool1, kGrindingValues}, kTool, kTool, 16, 3, 1, kFloating, toolOffset, setToolOffset, kGrinding},
    DataType{"TOA", {kTool1, kTurningValues}, kNone, kTool, 1, 0, 1, kFloating, nullptr, addToToolOffset, kOthers},
    DataType{"TOA", {kTool1, kGrindingValues}, kNone, kTool, 1, 0, 1, kFloating, nullptr, addToToolOffset, kGrinding},
    DataType{"ZOA", {kGroups, kAxis, kFlag}, kNumbers, kNumbers | kStored, 1, 0, 1, kPosition, settableOffset, setSettableOffset},
    DataType{"ZOPR", {kG58, kAxis}, kNumbers, kNumbers | kStored, 1, 0, 1, kPosition, programmableOffset, setProgrammableOffset},
    DataType{"ZOFA", {kGroups, kAxis, kFlag}, kNone, kNumbers | kStored, 1, 0, 1, kPosition, nullptr, addToSettableOffset},
    DataType{"ZOE", {kAxis}, kNumbers, kNumbers | kStored, 1, 0, 1, kPosition, externalOffset, setExternalOffset},
    DataType{"ZOPS", {kAxis}, kNumbers | kStored, kPresetWrite, 1, 0, 1, kPosition, preset, setPreset},
    DataType{"ZOS", {kAxis}, kActual, kNone, 1, 0, 1, kPosition, sumOffset, nullptr},
    DataType{"ACPW", {kAxis}, kActual, kNone, 1, 0, 1, kPosition, workpiecePosition, nullptr},
    DataType{"ACPM", {kAxis}, kActual, kNone, 1, 0, 1, kPosition, machinePosition, nullptr},
    DataType{"EXBF", {kChannel, kFlag}, kThousandths, kThousandths, 1, 0, 1, kFloating, externalFeed, setExternalFeed},
    DataType{"PP", {kChannel, kLevel}, kCounts, kNone, 1, 0, 3, kWhole, programPointer, nullptr},
    DataType{"INITMP", {kChannel}, kNone, kCounts, 1, 0, 1, kWhole, nullptr, selectMainProgram},
    DataType{"INITSP", {kChannel}, kNone, kCounts, 1, 0, 1, kWhole, nullptr, selectSubprogram},
    DataType{"RPNC", {kChannel, kR}, kParameter, kParameter, 80, 2, 1, kFloating, channelParameter, setChannelParameter},
    DataType{"RPNC", {kZero, kCentralR}, kParameter, kParameter, 80, 2, 1, kFloating, centralParameter, setCentralParameter},
    DataType{"NCAL", {}, kCounts, kNone, 127, 0, 1, kWhole, alarm, nullptr},
};
// clang-format on

bool onModel(const DataType& type, Model model) {
  return type.on == DataType::On::All ||
         (type.on == DataType::On::Grinding) == (model == Model::Grinding);
}

bool within(const Limit& limit, int value) {
  return !limit.used() || (value >= limit.low && value <= limit.high);
}

}  // namespace

std::span<const DataType> dataTypes() { return kTypes; }

const DataType* findDataType(std::string_view name, const Where& where, Model model) {
  const DataType* found = nullptr;
  for (const DataType& type : kTypes) {
    if (type.name != name || !onModel(type, model)) continue;
    if (found == nullptr || within(type.limits[0], where[0])) found = &type;
  }
  return found;
}

bool withinLimits(const DataType& type, const Where& where) {
  for (std::size_t i = 0; i < where.size(); ++i)
    if (!within(type.limits[i], where[i])) return false;
  return true;
}

}  // namespace merker::nc
