// What this machine can do at all: the bit operations written by hand in C++, optimised by the
// compiler (-O2). Compiled AWL is measured against it.
#include <benchmark/benchmark.h>

#include <utility>

#include "bit_operations.h"

namespace merker::bench {
namespace {

inline bool get(const std::uint8_t* bytes, Bit bit) {
  return (bytes[bit.byte] >> bit.bit & 1) != 0;
}

template <unsigned I>
[[gnu::always_inline]] inline void group(BitMemory& m) {
  constexpr BitGroup g = bitGroup(I);
  const bool result = (get(m.inputs, g.input) & !get(m.flags, g.flag)) | get(m.inputs, g.orInput);
  std::uint8_t& byte = m.outputs[g.output.byte];
  byte = static_cast<std::uint8_t>((byte & ~(1u << g.output.bit)) | result << g.output.bit);
}

constexpr unsigned kPart = 250;

template <unsigned From, unsigned... I>
void part(BitMemory& m, std::integer_sequence<unsigned, I...>) {
  (group<From + I>(m), ...);
}

template <unsigned... P>
void parts(BitMemory& m, std::integer_sequence<unsigned, P...>) {
  (part<P * kPart>(m, std::make_integer_sequence<unsigned, kPart>{}), ...);
}

void BitLogicLimit(benchmark::State& state) {
  BitMemory memory{};
  for (auto _ : state) {
    bitOperations(memory);
    benchmark::DoNotOptimize(memory);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kBitGroups * kOperationsPerGroup);
}
BENCHMARK(BitLogicLimit);

}  // namespace

void bitOperations(BitMemory& memory) {
  parts(memory, std::make_integer_sequence<unsigned, kBitGroups / kPart>{});
}

}  // namespace merker::bench
