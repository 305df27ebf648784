// STEP 5 on a SINUMERIK 810 GA3: OB 1 back to back.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>

#include "cnc/cnc.h"
#include "step5/compiler.h"

namespace merker::bench {
namespace {

// Bits, words of flags and data, sums, a comparison with a jump, a timer.
constexpr const char* kNetwork =
    " : U    E {0}.0\n : UN   M {0}.1\n : O    E {0}.2\n : =    A {0}.0\n"
    " : L    DW {1}\n : L    KF +5\n : +F\n : T    DW {1}\n"
    " : L    MW {2}\n : >F\n : SPB  =N{1:03}\n : U    E {0}.3\n : S    M {0}.4\n"
    "N{1:03} : U T 1\n : =    A {0}.1\n";

// OB 1 as a table of contents: one PB for each part of the machine, with a data block of its own.
std::string listing() {
  constexpr int kBlocks = 20, kNetworks = 5;
  std::string calls, blocks;
  for (int i = 0; i < kBlocks; ++i) {
    calls += fmt::format(" : SPA  PB {}\n", i);
    blocks += fmt::format("PB {}\n : A    DB {}\n : U    E {}.7\n : L    KT 100.1\n : SE   T 1\n",
                          i, 20 + i, i);
    for (int n = 0; n < kNetworks; ++n)
      blocks += fmt::format(fmt::runtime(kNetwork), i, n, 100 + 2 * n);
    blocks += " : BE\n";
    blocks +=
        fmt::format("DB {}\n", 20 + i) + std::string(" KF +0\n KF +0\n KF +0\n KF +0\n KF +0\n");
  }
  return "OB 1\n" + calls + " : BE\n" + blocks;
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
