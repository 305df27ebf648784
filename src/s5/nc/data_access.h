// Where the values of the data types are in the control. `w` is within the limits of its row.
#pragma once

#include "nc/data_type.h"

namespace merker::nc::access {

using Value = std::optional<Number>;

Value machineData(const Control& c, const Where& w, unsigned);
bool setMachineData(Control& c, const Where& w, Number n);
Value machineDataByte(const Control& c, const Where& w, unsigned);
bool setMachineDataByte(Control& c, const Where& w, Number n);
Value settingData(const Control& c, const Where& w, unsigned);
bool setSettingData(Control& c, const Where& w, Number n);
Value settingDataByte(const Control& c, const Where& w, unsigned);
bool setSettingDataByte(Control& c, const Where& w, Number n);

Value toolOffset(const Control& c, const Where& w, unsigned);
bool setToolOffset(Control& c, const Where& w, Number n);
bool addToToolOffset(Control& c, const Where& w, Number n);

Value settableOffset(const Control& c, const Where& w, unsigned);
bool setSettableOffset(Control& c, const Where& w, Number n);
bool addToSettableOffset(Control& c, const Where& w, Number n);
Value programmableOffset(const Control& c, const Where& w, unsigned);
bool setProgrammableOffset(Control& c, const Where& w, Number n);
Value externalOffset(const Control& c, const Where& w, unsigned);
bool setExternalOffset(Control& c, const Where& w, Number n);
Value preset(const Control& c, const Where& w, unsigned);
bool setPreset(Control& c, const Where& w, Number n);
Value sumOffset(const Control& c, const Where& w, unsigned);

Value workpiecePosition(const Control& c, const Where& w, unsigned);
Value machinePosition(const Control& c, const Where& w, unsigned);
Value externalFeed(const Control& c, const Where& w, unsigned);
bool setExternalFeed(Control& c, const Where& w, Number n);
Value programPointer(const Control& c, const Where& w, unsigned part);
bool selectMainProgram(Control& c, const Where& w, Number n);
bool selectSubprogram(Control& c, const Where& w, Number n);
Value channelParameter(const Control& c, const Where& w, unsigned);
bool setChannelParameter(Control& c, const Where& w, Number n);
Value centralParameter(const Control& c, const Where& w, unsigned);
bool setCentralParameter(Control& c, const Where& w, Number n);
Value alarm(const Control& c, const Where&, unsigned part);

}  // namespace merker::nc::access
