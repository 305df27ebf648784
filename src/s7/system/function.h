// A row of the table of system functions: number, name, parameters, function. The interface that
// the compiler sees and the function that runs come from the same row of functions.inc, library.inc
// or cp_library.inc.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "address/block_id.h"
#include "address/type_code.h"
#include "block/type.h"
#include "catalogue/block_library.h"
#include "catalogue/cpu_model.h"

namespace merker::system {

struct Invocation;
template <BlockKind kind, std::uint16_t number>
class Call;

// FC 5 of the Standard Library and that of SIMATIC_NET_CP are two functions: as types the latter
// has this number more.
constexpr std::uint16_t kCpRow = 0x8000;

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
  BlockLibrary library = BlockLibrary::Cpu;
};

// All rows that a model has with these libraries.
std::vector<Function> allFunctions(const CpuModel& model,
                                   const Libraries& libraries = standardLibraries());

// What the rows run.
#define FUNCTION(kind, number, name, function, requirement, parameters) \
  void function(Call<BlockKind::kind, number>&);
#define CP_FUNCTION(kind, number, name, function, requirement, parameters) \
  void function(Call<BlockKind::kind, kCpRow + number>&);
#define CODE(kind, number, code, text)
#define CODES(kind, number, group)
#define GROUP_CODE(group, code, text)
#include "system/cp_library.inc"
#include "system/functions.inc"
#include "system/library.inc"
#undef FUNCTION
#undef CP_FUNCTION
#undef CODE
#undef CODES
#undef GROUP_CODE

}  // namespace merker::system
