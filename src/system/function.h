// A row of the table of system functions: number, name, parameters, function. The interface that
// the compiler sees and the function that runs come from the same row.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "address/block_id.h"
#include "address/type_code.h"
#include "block/type.h"

namespace merker::system {

class Arguments;

struct Parameter {
  std::string_view name;
  block::Section section = block::Section::Input;
  TypeCode type = TypeCode::Word;
  std::uint16_t length = 254;  // STRING
};

struct Function {
  BlockKind kind = BlockKind::SFC;
  std::uint16_t number = 0;
  std::string_view name;
  std::vector<Parameter> parameters;  // IN, OUT, IN_OUT, RETURN, STAT
  void (*run)(Arguments&) = nullptr;
};

// Short names for the tables.
constexpr auto kIn = block::Section::Input;
constexpr auto kOut = block::Section::Output;
constexpr auto kReturn = block::Section::Return;
constexpr auto kStat = block::Section::Static;

using Functions = std::vector<Function>;
Functions clockFunctions();
Functions blockMoveFunctions();
Functions dataBlockFunctions();
Functions timeOfDayFunctions();
Functions delayFunctions();
Functions maskFunctions();
Functions lockFunctions();
Functions controlFunctions();
Functions bitFieldFunctions();
Functions iecCounters();
Functions iecTimers();
Functions dateTimeFunctions();
Functions dateTimeComparisons();
Functions stringFunctions();
Functions stringComparisons();
Functions stringConversions();
Functions selectFunctions();
Functions scaleFunctions();

// All rows.
Functions allFunctions();

}  // namespace merker::system
