// The programs in C (reference.h), in instructions or calls of the program in AWL a second.
#include <benchmark/benchmark.h>

#include "loops.h"
#include "programs.h"
#include "reference.h"
#include "started.h"

namespace merker::bench {
namespace {

void reference(benchmark::State& state, void (*program)(ReferenceMemory*), std::int64_t items) {
  ReferenceMemory memory{};
  for (auto _ : state) {
    program(&memory);
    benchmark::DoNotOptimize(memory);
  }
  state.SetItemsProcessed(state.iterations() * items);
}

#define LOOP_IN_C(name, function, body)                                          \
  void name(benchmark::State& s) {                                               \
    reference(s, function, static_cast<std::int64_t>(instructionsOfLoop(body))); \
  }                                                                              \
  BENCHMARK(name)->Apply(severalTimes)
LOOP_IN_C(MixedLoopInC, reference_mixed, kMixed);
LOOP_IN_C(RealsInC, reference_reals, kReals);
LOOP_IN_C(IndirectInC, reference_indirect, kIndirect);
LOOP_IN_C(TimersInC, reference_timers, kTimers);
#undef LOOP_IN_C

void FcCallsInC(benchmark::State& s) { reference(s, reference_function_calls, kCalls); }
BENCHMARK(FcCallsInC)->Apply(severalTimes);
void FbCallsInC(benchmark::State& s) { reference(s, reference_function_block_calls, kCalls); }
BENCHMARK(FbCallsInC)->Apply(severalTimes);

}  // namespace
}  // namespace merker::bench
