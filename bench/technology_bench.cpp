// The integrated counters at their fastest encoders, with the PLC that reads them in each cycle.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>

#include "catalogue/counting.h"
#include "programs.h"
#include "signal/encoder.h"
#include "station/station.h"

namespace merker::bench {
namespace {

std::string program(std::uint32_t channels) {
  std::string data, calls;
  for (std::uint32_t i = 0; i < channels; ++i) {
    data += fmt::format(
        "DATA_BLOCK DB {}\nSFB 47\nBEGIN\n  CHANNEL := {};\n  SW_GATE := TRUE;\n"
        "END_DATA_BLOCK\n",
        30 + i, i);
    calls += fmt::format("      CALL  SFB 47, DB {};\n", 30 + i);
  }
  return data + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + calls + "END_ORGANIZATION_BLOCK\n";
}

io::Configuration hardware(std::uint32_t channels) {
  io::Module counting;
  counting.type = onBoardType(defaultCpuModel(), 4);
  counting.slot = 2;
  counting.subslot = 4;
  counting.parameters = io::Parameters::of(*counting.type);
  for (std::uint32_t i = 0; i < channels; ++i) {
    io::CountChannel& channel = counting.parameters.counters[i];
    channel.mode = io::CountMode::Endless;
    channel.maxFrequency = 60;
    channel.latchFrequency = 10;
    channel.evaluation = io::Evaluation::Quadruple;
  }
  Problems problems;
  return io::configure({counting}, defaultCpuModel(), problems);
}

// Each channel at 60 kHz with quadruple evaluation: 240 000 counts in a second of the machine.
void count(benchmark::State& state, std::uint32_t channels) {
  station::Options options;
  options.program = compiled(program(channels));
  options.hardware = hardware(channels);
  station::Station station(std::move(options));
  if (!station.warmRestart()) std::abort();
  station.advanceCycles(2);
  io::Rack& rack = *station.rack();
  const auto attach = [&](std::uint32_t input, signal::Track track, const signal::Motion& motion) {
    rack.attach(*rack.terminal("2.2", io::Side::DigitalInput, input),
                std::make_shared<signal::EncoderTrack>(motion, track), station.now());
  };
  for (std::uint32_t i = 0; i < channels; ++i) {
    const CountingPins& pins = countingType(defaultCpuModel())->channels[i];
    // not all in the same phase
    const signal::Motion motion{station.now() + Duration::microseconds(i), 0, 60'000'000, 0};
    attach(pins.a.channel, signal::Track::A, motion);
    attach(pins.b.channel, signal::Track::B, motion);
  }
  constexpr Duration kStep = Duration::milliseconds(100);
  for (auto _ : state) station.advanceTo(station.now() + kStep);
  constexpr std::int64_t kCountsOfAStep = 24'000;
  state.SetItemsProcessed(state.iterations() * kCountsOfAStep * channels);
  if (station.mode() != station::Mode::Run) state.SkipWithError(station.stopReason().c_str());
}

void CountedEncoder(benchmark::State& state) { count(state, 1); }
void CountedEncoders(benchmark::State& state) { count(state, 4); }
BENCHMARK(CountedEncoder);
BENCHMARK(CountedEncoders);

}  // namespace
}  // namespace merker::bench
