#include "programs.h"

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

#include "bit_operations.h"
#include "step7/compiler.h"
#include "system/library.h"

namespace merker::bench {
namespace {

// Ten lines about a motor; {0} and {1} are byte addresses, {2} makes the label unique.
constexpr std::string_view kMotor = R"(      U     E {0}.0             // start
      O     M {0}.1
      UN    E {0}.2             // stop
      =     M {0}.1             // runs
      L     MW {1}              // setpoint
      L     100
      <=I
      SPBN  m{2}
      T     MW {1}
m{2}: U     M {0}.1
)";

// Ten lines of calculation.
constexpr std::string_view kCalculation = R"(      L     MW {0}
      L     MW {1}
      +I
      L     2
      *I
      T     MW {1}
      L     MD {0}
      L     L#5
      +D
      T     MD {1}
)";

// Ten lines that come to the same result as long as nothing changes.
constexpr std::string_view kScaling = R"(      L     MW {0}
      L     27
      *I
      L     MW {1}
      +I
      T     MW {2}
      L     MD {0}
      L     L#5
      +D
      T     MD {3}
)";

// Three in, two out.
constexpr std::string_view kFiveParameters = R"(VAR_INPUT
  a : INT ;
  b : INT ;
  c : BOOL ;
END_VAR
VAR_OUTPUT
  d : INT ;
  e : BOOL ;
END_VAR
BEGIN
NETWORK
      L     #a
      L     #b
      +I
      T     #d
      U     #c
      =     #e
)";

std::string body(int lines) {
  std::string text;
  for (int i = 0; i < lines / 20; ++i) {
    const int byte = i % 100;
    text += fmt::format(fmt::runtime(kMotor), byte, 100 + 2 * (i % 70), i);
    text += fmt::format(fmt::runtime(kCalculation), byte, 100 + 2 * (i % 70));
  }
  return text;
}

std::string function(int number, int lines) {
  return fmt::format(
      "FUNCTION FC {} : VOID\nTITLE = motors\nVAR_INPUT\n  speed : INT ; // 1/min\nEND_VAR\n"
      "VAR_TEMP\n  scratch : INT ;\nEND_VAR\nBEGIN\nNETWORK\n      L     #speed\n      T     "
      "#scratch\n"
      "{}      BE\nEND_FUNCTION\n",
      number, body(lines));
}

std::string organizationBlock(const std::string& code) {
  return "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  info : ARRAY [0 .. 19] OF BYTE "
         ";\nEND_VAR\nBEGIN\nNETWORK\n" +
         code + "END_ORGANIZATION_BLOCK\n";
}

}  // namespace

std::string largeSource(int lines) {
  constexpr int kLinesPerFunction = 1000;
  std::string text, calls;
  for (int i = 1; i <= lines / kLinesPerFunction; ++i) {
    text += function(i, kLinesPerFunction);
    calls += fmt::format("      CALL  FC {} ( speed := {} )\n", i, i);
  }
  return text + organizationBlock(calls);
}

std::string mixedSource() {
  constexpr std::string_view kReal =
      "      L     MD 200\n      L     1.5\n      *R\n      T     MD 204\n";
  std::string code;
  for (int i = 0; i < 100; ++i) {
    code += fmt::format(fmt::runtime(kMotor), i % 100, 100 + 2 * (i % 50), i);
    code += fmt::format(fmt::runtime(kCalculation), i % 90, 100 + 2 * (i % 45));
    if (i % 10 == 0) code += kReal;
  }
  return organizationBlock(code);
}

std::string callingSource(int calls, Callee callee) {
  const bool fb = callee == Callee::FunctionBlock;
  const std::string block = fb ? "FUNCTION_BLOCK FB 1\n" : "FUNCTION FC 1 : VOID\n";
  const std::string end =
      fb ? "END_FUNCTION_BLOCK\nDATA_BLOCK DB 1 FB 1\nBEGIN\nEND_DATA_BLOCK\n" : "END_FUNCTION\n";
  std::string code;
  for (int i = 0; i < calls; ++i)
    code += fmt::format(
        "      CALL  {} ( a := MW 10, b := MW 12, c := M 2.0, d := MW 14, e := M 2.1 )\n",
        fb ? "FB 1 , DB 1" : "FC 1");
  return block + std::string(kFiveParameters) + end + organizationBlock(code);
}

std::string controlSource(int instructions) {
  std::string code;
  for (int i = 0; i < instructions / 20; ++i) {
    const int byte = i % 100, setpoint = 100 + 2 * (i % 50);
    code += fmt::format(fmt::runtime(kMotor), byte, setpoint, i);
    code +=
        fmt::format(fmt::runtime(kScaling), byte, setpoint, 200 + 2 * (i % 20), 240 + 4 * (i % 4));
  }
  code += "      U     M 0.1\n      L     S5T#10MS\n      SE    T 1\n";
  return organizationBlock(code);
}

std::string bitSource() {
  std::string code;
  for (unsigned i = 0; i < kBitGroups; ++i) {
    const BitGroup g = bitGroup(i);
    code += fmt::format(" U E {}.{}\n UN M {}.{}\n O E {}.{}\n = A {}.{}\n", g.input.byte,
                        g.input.bit, g.flag.byte, g.flag.bit, g.orInput.byte, g.orInput.bit,
                        g.output.byte, g.output.bit);
  }
  return organizationBlock(code);
}

std::string loopSource(const std::string& body) {
  return organizationBlock("      L     1000\nnext: T     MW 100\n" + body +
                           "      L     MW 100\n      LOOP  next\n");
}

std::shared_ptr<const block::Program> compiled(const std::string& source, const char* model) {
  std::vector<source::SourceFile> sources;
  sources.emplace_back("bench.awl", source);
  step7::CompileOptions options;
  options.model = findCpuModel(model);
  const block::Program library = system::library(*options.model);
  options.library = &library;
  step7::Compilation compilation = step7::compile(sources, options);
  if (!compilation.ok()) {
    std::cerr << source::format(compilation.problems.list().front(), &sources.front()) << '\n';
    std::exit(1);
  }
  return std::make_shared<const block::Program>(std::move(compilation.program));
}

}  // namespace merker::bench
