// Parameters of system functions by name: found in the row while Merker is compiled, and a name
// that the row does not have does not compile.
#include "system/parameter_name.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "catalogue/cpu_model.h"
#include "system/function.h"

namespace merker::system {
namespace {

template <std::size_t size>
struct Text {
  char text[size];
  consteval Text(const char (&literal)[size]) {
    for (std::size_t i = 0; i < size; ++i) text[i] = literal[i];
  }
};

// True if `ParameterName<kind, number>{name}` compiles.
template <BlockKind kind, std::uint16_t number, Text name>
concept Compiles = requires {
  typename std::integral_constant<std::size_t, ParameterName<kind, number>(name.text).index>;
};
template <BlockKind kind, std::uint16_t number>
concept HasRow = requires {
  typename std::integral_constant<std::size_t, parametersInRow(kind, number).size()>;
};

static_assert(Compiles<BlockKind::SFB, 47, "LADDR">);
static_assert(!Compiles<BlockKind::SFB, 47, "LADR">);
static_assert(!Compiles<BlockKind::SFB, 47, "laddr">);
static_assert(!Compiles<BlockKind::SFB, 47, "WORD">);  // its type
static_assert(!Compiles<BlockKind::SFB, 47, "in">);    // its section
static_assert(!Compiles<BlockKind::SFB, 47, "CTRL">);  // the beginning of CTRL_DO
static_assert(!Compiles<BlockKind::SFB, 47, "">);
static_assert(!Compiles<BlockKind::SFB, 49, "LATCHVAL">);  // of SFB 47
static_assert(!Compiles<BlockKind::SFC, 43, "RET_VAL">);   // has no parameters
static_assert(HasRow<BlockKind::SFB, 47> && HasRow<BlockKind::FC, 105>);
static_assert(!HasRow<BlockKind::SFB, 6> && !HasRow<BlockKind::SFC, 47 + 1000>);

TEST(ParameterName, IndexIsThePlaceInTheRow) {
  EXPECT_EQ((ParameterName<BlockKind::SFB, 47>{"LADDR"}.index), 0u);  // has a start value
  EXPECT_EQ((ParameterName<BlockKind::SFB, 47>{"CHANNEL"}.index), 1u);
  EXPECT_EQ((ParameterName<BlockKind::SFB, 47>{"TIMEVAL"}.index), 31u);  // the last one
  EXPECT_EQ((ParameterName<BlockKind::SFC, 20>{"RET_VAL"}.index), 2u);
  EXPECT_EQ((ParameterName<BlockKind::FC, 105>{"HI_LIM"}.index), 1u);
}

// What compiles by name runs by number: both must count a row alike.
TEST(ParameterName, CountsAsTheTableOfFunctionsDoes) {
  std::size_t parameters = 0;
  for (const CpuModel& model : cpuModels())
    for (const Function& function : allFunctions(model)) {
      const std::string_view row = parametersInRow(function.kind, function.number);
      for (std::size_t i = 0; i < function.parameters.size(); ++i, ++parameters)
        EXPECT_EQ(indexInRow(row, function.parameters[i].name), i)
            << function.name << " " << function.parameters[i].name;
    }
  EXPECT_GT(parameters, 300u);
}

}  // namespace
}  // namespace merker::system
