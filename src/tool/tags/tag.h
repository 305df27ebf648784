// The tags of a project: what HMI, SCADA and gateways read and write by a name and an address.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "address/area.h"
#include "address/type_code.h"
#include "compilation/build.h"

namespace merker::tags {

enum class TagArea : std::uint8_t {
  Input,
  Output,
  Flag,
  PeripheralInput,
  PeripheralOutput,
  Data,
  Timer,
  Counter
};

struct Tag {
  // Of a symbol its name; of data the block and the names in it: {"Recipe", "Step[1]", "Speed"}.
  std::vector<std::string> path;
  TagArea area = TagArea::Flag;
  std::uint16_t db = 0;  // Data
  BitAddress at = 0;     // Timer, Counter: the number
  TypeCode type = TypeCode::Bool;
  std::uint16_t length = 0;  // STRING: most characters
  std::string comment;
  bool writable = true;  // not: inputs of the peripherals, data blocks that are READ_ONLY
  // Not: outputs of the peripherals, in whose place a PLC shows the inputs of the same address.
  bool readable = true;
};

struct TagOptions {
  bool data = true;  // the variables of data blocks too
};

// The symbols for inputs, outputs, flags, peripherals, timers and counters in the order of their
// table, then the variables of data blocks by number and place, without blocks that are UNLINKED: a
// PLC does not let anybody read them. A program of STEP 5 declares no
// variables: its data words with a name are those of whatever block is open, and are left out.
std::vector<Tag> listTags(const compilation::Build& build, const TagOptions& options = {});

// "Recipe.Step[1].Speed"
std::string fullName(const Tag& tag);

}  // namespace merker::tags
