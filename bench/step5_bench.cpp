// STEP 5 on a SINUMERIK 810 GA3: OB 1 back to back.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>

#include "control/cnc.h"
#include "step5/compiler.h"

namespace merker::bench {
namespace {

// Bits, a sum in a data word, a timer; the function block has its own for each call.
constexpr const char* kNetwork =
    " : U    E {0}.0\n : UN   M {1}.1\n : O    E {0}.2\n : =    A {0}.0\n : U    E {0}.3\n"
    " : S    M {1}.4\n : U    T 1\n : R    M {1}.4\n : L    DW {2}\n : L    KF +5\n : +F\n"
    " : T    DW {2}\n : SPA  FB 20\nNAME : MOTOR\nEIN  : E {0}.1\nSOLL : MW {1}\n"
    "LAUF : A {0}.1\n";
constexpr const char* kDrive =
    "FB 20\nNAME : MOTOR\nBEZ  : EIN   E/A/D/B/T/Z: E   BI/BY/W/D: BI\n"
    "BEZ  : SOLL  E/A/D/B/T/Z: E   BI/BY/W/D: W\nBEZ  : LAUF  E/A/D/B/T/Z: A   BI/BY/W/D: BI\n"
    " : U    =EIN\n : U    M 100.0\n : =    =LAUF\n : L    =SOLL\n : L    KF +100\n : >F\n"
    " : SPB  =LANG\n : L    DW 5\n : +F\n : T    MW 98\nLANG : U M 100.1\n : BE\n";

// OB 1 as a table of contents: one PB for each part of the machine, with a data block of its own.
std::string listing() {
  constexpr int kBlocks = 20, kNetworks = 5, kFirstData = 40;
  std::string calls, blocks;
  for (int i = 0; i < kBlocks; ++i) {
    calls += fmt::format(" : SPA  PB {}\n", i);
    blocks += fmt::format("PB {}\n : A    DB {}\n : U    E {}.7\n : L    KT 100.1\n : SE   T 1\n",
                          i, kFirstData + i, i);
    for (int n = 0; n < kNetworks; ++n)
      blocks += fmt::format(fmt::runtime(kNetwork), i, 110 + 4 * i, n);
    blocks += fmt::format(" : BE\nDB {}\n", kFirstData + i);
    for (int n = 0; n <= kNetworks; ++n) blocks += "   KF = +0\n";
  }
  return "OB 1\n" + calls + " : BE\n" + kDrive + blocks;
}

void run(benchmark::State& state, bool isCompiled) {
  constexpr Duration kMost = Duration::seconds(1);
  const step5::Compilation compilation =
      step5::compile({source::SourceFile("bench.s5", listing())}, false);
  if (!compilation.ok()) return state.SkipWithError("the listing has errors");
  cnc::Options options;
  options.plc.program = compilation.program;
  options.compiled = isCompiled;
  cnc::Cnc control(std::move(options));
  control.start();
  control.advanceCycles(1);
  const std::uint64_t before = control.instructions();
  for (auto _ : state) control.plc().runOb1(kMost);
  state.SetItemsProcessed(static_cast<std::int64_t>(control.instructions() - before));
  if (control.mode() != controller::Mode::Run) state.SkipWithError(control.stopReason().c_str());
}

void Step5(benchmark::State& state) { run(state, false); }
BENCHMARK(Step5);
void Step5Compiled(benchmark::State& state) { run(state, true); }
BENCHMARK(Step5Compiled);

}  // namespace
}  // namespace merker::bench
