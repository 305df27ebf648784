// The type and the address of a tag as the drivers of other tools write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tags/tag.h"

namespace merker::tags {

// A tool: its words for types, and what its addresses can name.
struct Tool {
  // Of a type in a data block ("REAL" of "DB1,REAL4"), in other areas ("R" of "MR4"), and of the
  // tag itself ("Float"). Empty: the tool cannot have such a value there.
  std::string_view (*inData)(TypeCode type);
  std::string_view (*elsewhere)(TypeCode type);
  std::string_view (*tagType)(TypeCode type);
  bool peripherals;  // "PIW256"
};
// Kepware, Siemens TCP/IP Ethernet: "Standard S7-300/400/1200/1500 Item Syntax" of its manual.
extern const Tool kKepware;
// Ignition, Siemens drivers: "Address Syntax" of its manual.
extern const Tool kIgnition;
// node-red-contrib-s7: "Variable addressing" of its README.
extern const Tool kNodeRed;

// Nothing if the tool has no address for this area or type.
std::optional<std::string> address(const Tag& tag, const Tool& tool);

// As STEP 7 writes it: "E 0.0", "DB10.DBW 4", "T 1"; "DB10.DBB 4" where a value is longer.
std::string step7Address(const Tag& tag, Mnemonics mnemonics);

// FUXA's word for the type of a tag: "Bool", "DInt"; empty if its driver does not know it.
std::string_view fuxaType(TypeCode type);

}  // namespace merker::tags
