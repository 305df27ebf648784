// A CPU 314C-2 PtP whose RK 512 line is always busy: it fetches 128 bytes of its partner without a
// pause, at 9600 baud; and a thousand of them in one process.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "programs.h"
#include "serial/coupling.h"
#include "together.h"

namespace merker::bench {
namespace {

constexpr std::string_view kFetching = R"(DATA_BLOCK DB 20
STRUCT
  D : ARRAY [0 .. 127] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 50
STRUCT
  S : ARRAY [0 .. 239] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 64 SFB 64
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     128
      T     MW 12
      CALL  SFB 64, DB 64 (SYNC_DB := 50, REQ := M 0.0, R := FALSE, LADDR := W#16#3FF, R_CPU := 1, R_TYPE := 'D', R_DBNO := 20, R_OFFSET := 0, R_CF_BYT := 255, R_CF_BIT := 0, DONE := M 1.2, ERROR := M 1.3, STATUS := MW 6, RD_1 := P#DB20.DBX0.0 BYTE 1, LEN := MW 12)
      U     M 1.2
      SPBN  done
      L     MW 20
      +     1
      T     MW 20
done: UN    M 1.2
      UN    M 1.3
      =     M 0.0
END_ORGANIZATION_BLOCK
)";

io::Configuration computerLink() {
  io::Module module;
  module.type = onBoardType(defaultCpuModel(), 1);
  module.slot = 2;
  module.subslot = 1;
  module.parameters = io::Parameters::of(*module.type);
  module.parameters.serial =
      std::make_shared<serial::Parameters>(serial::defaults(serial::Protocol::ComputerLink));
  Problems problems;
  return io::configure({module}, defaultCpuModel(), problems);
}

using station::Station;

Station busy(const std::shared_ptr<const block::Program>& program) {
  station::Options options;
  options.program = program;
  options.hardware = computerLink();
  options.engine = station::Engine::Compiled;
  Station station(std::move(options));
  if (!station.warmRestart()) std::abort();
  serial::Coupling& coupling = *station.serial();
  serial::ProcedureParameters partner = coupling.parameters().procedure;
  partner.highPriority = false;
  coupling.partner().speak(serial::Partner::Speaks::ComputerLink, partner, station.now());
  coupling.partner().memory().set('D', 20, 0, serial::Bytes(128, 0x55));
  return station;
}

// It runs, and jobs have ended.
void check(Station& station, benchmark::State& state) {
  if (station.mode() != station::Mode::Run) state.SkipWithError(station.stopReason().c_str());
  if (station.serial()->seen() == 0) state.SkipWithError("nothing was on the line");
}

std::shared_ptr<const block::Program> fetching() {
  return compiled(std::string(kFetching), "314C-2 PtP");
}

void BusyComputerLink(benchmark::State& state) {
  Station station = busy(fetching());
  constexpr Duration kStep = Duration::milliseconds(500);
  const Instant begin = station.now();
  for (auto _ : state) station.advanceTo(station.now() + kStep);
  state.SetItemsProcessed((station.now() - begin).ns);
  check(station, state);
}
BENCHMARK(BusyComputerLink);

// All of them together one virtual second.
void ThousandComputerLinks(benchmark::State& state) {
  constexpr std::size_t kCpus = 1000;
  constexpr Duration kTime = Duration::seconds(1);
  const auto program = fetching();
  Together stations(kCpus, [&] { return busy(program); });
  for (auto _ : state) stations.advance(kTime);
  state.SetItemsProcessed(state.iterations() * kTime.ns);
  for (std::size_t i = 0; i < kCpus; ++i) check(stations.station(i), state);
}
BENCHMARK(ThousandComputerLinks)->UseRealTime()->Iterations(3);

}  // namespace
}  // namespace merker::bench
