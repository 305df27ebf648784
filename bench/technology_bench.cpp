// The integrated counter at its fastest encoder, with the PLC that reads it in each cycle.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "programs.h"
#include "signal/encoder.h"
#include "station/station.h"

namespace merker::bench {
namespace {

constexpr std::string_view kProgram = R"(
DATA_BLOCK DB 30
SFB 47
BEGIN
  SW_GATE := TRUE;
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  SFB 47, DB 30;
END_ORGANIZATION_BLOCK
)";

io::Configuration hardware() {
  io::Module counting;
  counting.type = onBoardType(defaultCpuModel(), 4);
  counting.slot = 2;
  counting.subslot = 4;
  counting.parameters = io::Parameters::of(*counting.type);
  io::CountChannel& channel = counting.parameters.counters[0];
  channel.mode = io::CountMode::Endless;
  channel.maxFrequency = 60;
  channel.latchFrequency = 10;
  channel.evaluation = io::Evaluation::Quadruple;
  Problems problems;
  return io::configure({counting}, defaultCpuModel(), problems);
}

// 60 kHz with quadruple evaluation: 240 000 counts in a second of the machine.
void CountedEncoder(benchmark::State& state) {
  station::Options options;
  options.program = compiled(std::string(kProgram));
  options.hardware = hardware();
  station::Station station(std::move(options));
  if (!station.warmRestart()) std::abort();
  station.advanceCycles(2);
  io::Rack& rack = *station.rack();
  const signal::Motion motion{station.now(), 0, 60'000'000, 0};
  for (const auto track : {signal::Track::A, signal::Track::B})
    rack.attach(*rack.terminal("2.2", io::Side::DigitalInput, track == signal::Track::A ? 0 : 1),
                std::make_shared<signal::EncoderTrack>(motion, track), station.now());
  constexpr Duration kStep = Duration::milliseconds(100);
  for (auto _ : state) station.advanceTo(station.now() + kStep);
  constexpr std::int64_t kCountsOfAStep = 24'000;
  state.SetItemsProcessed(state.iterations() * kCountsOfAStep);
  if (station.mode() != station::Mode::Run) state.SkipWithError(station.stopReason().c_str());
}
BENCHMARK(CountedEncoder);

}  // namespace
}  // namespace merker::bench
