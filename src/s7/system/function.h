// A row of the table of system functions: number, name, parameters, function. The interface that
// the compiler sees and the function that runs come from the same row of functions.inc or
// library.inc.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "address/block_id.h"
#include "address/type_code.h"
#include "block/type.h"
#include "catalogue/cpu_model.h"

namespace merker::system {

struct Invocation;
template <BlockKind kind, std::uint16_t number>
class Call;

struct Parameter {
  std::string_view name;
  block::Section section = block::Section::Input;
  TypeCode type = TypeCode::Word;
  std::uint32_t initial = 0;  // start value in an instance data block
  std::size_t entry = 0;      // FC, SFC: its number in the parameter list (block::parameters)
};

struct Function {
  BlockKind kind = BlockKind::SFC;
  std::uint16_t number = 0;
  std::string_view name;
  std::vector<Parameter> parameters;         // IN, OUT, IN_OUT, RETURN, STAT
  bool (*run)(const Invocation&) = nullptr;  // false: BIE 0
};

// All rows that a model has.
std::vector<Function> allFunctions(const CpuModel& model);

// What the rows run.
#define FUNCTION(kind, number, name, function, requirement, parameters) \
  void function(Call<BlockKind::kind, number>&);
#define CODE(kind, number, code, text)
#define CODES(kind, number, group)
#define GROUP_CODE(group, code, text)
#include "system/functions.inc"
#include "system/library.inc"
#undef FUNCTION
#undef CODE
#undef CODES
#undef GROUP_CODE

}  // namespace merker::system
