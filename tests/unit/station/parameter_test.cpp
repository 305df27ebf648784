// Parameters of the CPU (S7-HWCFG-08), download in RUN, many stations.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "cpu/clock_memory.h"
#include "cpu/cpu.h"
#include "program.h"

namespace merker::station::test {
namespace {

CpuParameters defaults() { return CpuParameters::of(defaultCpuModel()); }
const CpuModel& model() { return defaultCpuModel(); }

// S7-MEM-01: edges over 20 s, duty 1:1, also inside a long cycle.
TEST(ClockMemory, EightSquareWaves) {
  CpuParameters parameters = defaults();
  parameters.clockMemory = 100;
  Plc plc(ob(1, ""), model(), parameters);
  plc.start();
  unsigned edges[8] = {}, high[8] = {};
  std::uint32_t before = 0;
  for (int ms = 0; ms < 20'000; ms += 5) {
    plc->advanceTo(Instant{} + Duration::milliseconds(ms));
    const std::uint32_t now = plc.read("MB 100");
    for (unsigned bit = 0; bit < 8; ++bit) {
      edges[bit] += (now & ~before) >> bit & 1;
      high[bit] += now >> bit & 1;
    }
    before = now;
  }
  const unsigned expected[8] = {200, 100, 50, 40, 25, 20, 12, 10};  // rising, in 20 s
  for (unsigned bit = 0; bit < 8; ++bit) {
    EXPECT_EQ(edges[bit], expected[bit]) << bit;
    if (bit != 6) {
      EXPECT_NEAR(high[bit], 2'000, 3) << bit;
    }
  }
}

TEST(ClockMemory, ChangesInTheMiddleOfACycle) {
  CpuParameters parameters = defaults();
  parameters.clockMemory = 100;
  Plc plc(ob(1,
             "L 0; T MW 0; M001: UN M 100.0; SPB M001; CALL SFC 64 (RET_VAL := MD 4);"
             "M002: U M 100.0; SPB M002; CALL SFC 64 (RET_VAL := MD 8);"),
          model(), parameters);
  plc.cycles(1);
  EXPECT_EQ(plc.read("MD 4"), 50u);
  EXPECT_EQ(plc.read("MD 8"), 100u);
}

// S7-HWCFG-08, S7-BLK-10, S7-OBI-05: interval and phase.
TEST(Parameters, CyclicInterrupts) {
  CpuParameters parameters = defaults();
  parameters.cyclic = {{.ob = 35, .interval = 50, .phase = 20}};
  Plc plc(ob(35, "L MW 0; + 1; T MW 0; L LW 6; T MW 2; L LW 10; T MW 4;") + ob(1, ""), model(),
          parameters);
  plc.start();
  plc->advanceTo(plc->now() + Duration::milliseconds(69));
  EXPECT_EQ(plc.read("MW 0"), 0u);
  plc.run(Duration::milliseconds(2));
  EXPECT_EQ(plc.read("MW 0"), 1u);
  plc.run(Duration::milliseconds(100));
  EXPECT_EQ(plc.read("MW 0"), 3u);
  EXPECT_EQ(plc.read("MW 2"), 20u);
  EXPECT_EQ(plc.read("MW 4"), 50u);
}

// S7-HWCFG-08, S7-CPU-29
TEST(Parameters, CycleMonitoringAndMinimumCycle) {
  CpuParameters parameters = defaults();
  parameters.cycleMonitoring = 30;
  Plc slow(ob(1, "M001: SPA M001;"), model(), parameters);
  slow.start();
  slow.run(Duration::milliseconds(40));
  EXPECT_EQ(slow.lastEvent(), 0x4568u);
  EXPECT_GE(slow->now().ns, 30'000'000);

  parameters.minimumCycle = 20;
  Plc plc(ob(1, "L LW 6; T MW 0;"), model(), parameters);
  plc.start();
  plc.run(Duration::milliseconds(205));
  EXPECT_EQ(plc->cycles(), 11u);
  EXPECT_EQ(plc.read("MW 0"), 20u);
}

// docs/compatibility.md, "communication load": 50 % doubles the cycle while somebody exchanges
// data.
TEST(Parameters, CommunicationLoad) {
  CpuParameters parameters = defaults();
  parameters.communicationLoad = 50;
  Plc plc(ob(1, "CALL SFC 47 (WT := 9500);"), model(), parameters);
  plc.start();
  plc.run(Duration::milliseconds(1'000));
  const auto alone = plc->cycles();
  plc->cpu().communicate(true);
  plc.run(Duration::milliseconds(1'000));
  EXPECT_NEAR(static_cast<double>(alone), 100, 1);
  EXPECT_NEAR(static_cast<double>(plc->cycles() - alone), 50, 1);
}

// S7-HWCFG-08, S7-CPU-28, S7-MEM-02
TEST(Parameters, RetentiveRanges) {
  CpuParameters parameters = defaults();
  parameters.retentiveFlags = 4;
  Plc plc(ob(1, ""), model(), parameters);
  plc.cycles(1);
  plc.write("MB 3", 3);
  plc.write("MB 4", 4);
  plc->stop();
  plc.cycles(1);
  EXPECT_EQ(plc.read("MB 3"), 3u);
  EXPECT_EQ(plc.read("MB 4"), 0u);
}

// S7-HWCFG-08, S7-OBI-03; without OB 10 OB 85 (S7-OBI-10).
TEST(Parameters, TimeOfDayInterrupt) {
  CpuParameters parameters = defaults();
  parameters.timeOfDay = {{.ob = 10, .active = true, .period = 0x0201, .start = 0}};
  Plc plc(ob(10, "L MW 0; + 1; T MW 0;") + ob(1, ""), model(), parameters);
  plc.start();
  plc.run(Duration::milliseconds(120'100));
  EXPECT_EQ(plc.read("MW 0"), 2u);
  Plc missing(ob(85, "L MW 0; + 1; T MW 0; L LD 0; T MD 4;") + ob(1, ""), model(), parameters);
  missing.start();
  missing.run(Duration::milliseconds(60'100));
  EXPECT_EQ(missing.read("MD 4"), 0x35A11A55u);
}

// S7-OBI-10: a configured module does not answer while the images are updated.
TEST(Parameters, ImageErrors) {
  const std::string program =
      ob(85, "L MW 0; + 1; T MW 0; L LD 0; T MD 4; L LW 10; T MW 8;") + ob(1, "L EB 4; T MB 20;");
  const auto run = [&](ImageErrors when) {
    CpuParameters parameters = defaults();
    parameters.imageErrors = when;
    auto plc = std::make_unique<Plc>(program, model(), parameters);
    cpu::Areas& areas = (*plc)->cpu().machine().areas;
    areas.inputConfigured.assign(areas.imageBytes, true);
    areas.outputConfigured.assign(areas.imageBytes, false);
    areas.inputs[4] = 0x44;
    plc->cycles(2);
    EXPECT_EQ(plc->read("MB 20"), 0x44u);
    areas.inputPresent[4] = areas.inputPresent[5] = false;
    (*plc)->advanceCycles(3);
    EXPECT_EQ(plc->read("MB 20"), 0u);
    return plc;
  };
  EXPECT_EQ(run(ImageErrors::None)->read("MW 0"), 0u);
  const auto each = run(ImageErrors::EachCycle);
  EXPECT_EQ(each->read("MW 0"), 3u);
  EXPECT_EQ(each->read("MD 4"), 0x39B11A55u);
  EXPECT_EQ(each->read("MW 8"), 4u);
  const auto once = run(ImageErrors::ComingAndGoing);
  EXPECT_EQ(once->read("MW 0"), 1u);
  EXPECT_EQ(once->read("MD 4"), 0x39B31A55u);
  cpu::Areas& areas = (*once)->cpu().machine().areas;
  areas.inputPresent[4] = areas.inputPresent[5] = true;
  (*once)->advanceCycles(2);
  EXPECT_EQ(once->read("MW 0"), 2u);
  EXPECT_EQ(once->read("MD 4"), 0x38B31A55u);
}

// S7-OBI-10: B2 and B4 for outputs; each range of bytes is one call, its first byte stands for it.
TEST(Parameters, ImageErrorsOfOutputs) {
  const auto run = [&](ImageErrors when) {
    CpuParameters parameters = defaults();
    parameters.imageErrors = when;
    auto plc = std::make_unique<Plc>(ob(85,
                                        "L MW 0; + 1; T MW 0; L LD 0; T MD 4; L LW 10; T MW 8; L "
                                        "MW 10; L LW 10; +I; T MW 10; L LB 4; T MB 12;") +
                                         ob(1, ""),
                                     model(), parameters);
    cpu::Areas& areas = (*plc)->cpu().machine().areas;
    areas.inputConfigured.assign(areas.imageBytes, true);
    areas.outputConfigured.assign(areas.imageBytes, true);
    areas.outputConfigured[9] = false;
    plc->cycles(2);
    for (const unsigned byte : {2u, 3u, 6u, 9u}) areas.outputPresent[byte] = false;
    (*plc)->advanceCycles(1);
    return plc;
  };
  for (const ImageErrors when : {ImageErrors::EachCycle, ImageErrors::ComingAndGoing}) {
    const auto plc = run(when);
    EXPECT_EQ(plc->read("MW 0"), 2u);
    EXPECT_EQ(plc->read("MW 10"), 2u + 6u);
    EXPECT_EQ(plc->read("MB 12"), 0x10u);  // by bytes
    EXPECT_EQ(plc->read("MD 4"), when == ImageErrors::EachCycle ? 0x39B21A55u : 0x39B41A55u);
  }
}

// S7-MEM-05, S7-SIM-11
TEST(Protection, LevelsAndSwitch) {
  CpuParameters parameters = defaults();
  Plc open(ob(1, ""), model(), parameters);
  EXPECT_TRUE(open->mayRead() && open->mayWrite());
  open->setSwitch(cpu::SwitchPosition::Run);
  EXPECT_FALSE(open->mayWrite());
  parameters.protection = 2;
  parameters.password = "secret";
  Plc writing(ob(1, ""), model(), parameters);
  EXPECT_TRUE(writing->mayRead());
  EXPECT_FALSE(writing->mayWrite("wrong"));
  EXPECT_TRUE(writing->mayWrite("secret"));
  parameters.protection = 3;
  Plc closed(ob(1, ""), model(), parameters);
  EXPECT_FALSE(closed->mayRead());
  EXPECT_TRUE(closed->mayRead("secret"));
}

const std::string kFc50 =
    "FUNCTION FC 50 : VOID\nBEGIN\nL MW 2; L VALUE; +I; T MW 2; CALL SFC 47 (WT := 5000);"
    "L MW 4; L VALUE; +I; T MW 4;\nEND_FUNCTION\n";
std::string withFc50(std::string_view value) {
  std::string text = kFc50;
  for (auto at = text.find("VALUE"); at != std::string::npos; at = text.find("VALUE"))
    text.replace(at, 5, value);
  return text;
}

// S7-CYCLE-05, S7-LIM-04: a changed FC counts from the next cycle on, never half of it.
TEST(Download, ActsAtTheCheckpoint) {
  const std::string data =
      "DATA_BLOCK DB 1\nSTRUCT\n a : INT := 3;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  Plc plc(data + withFc50("1") + ob(1, "CALL FC 50;"));
  plc.start();
  plc->advanceTo(plc->now() + Duration::milliseconds(2));
  EXPECT_EQ(plc.read("MW 2"), 1u);
  plc.write("DB1.DBW 0", 9);
  const std::string added =
      "DATA_BLOCK DB 2\nSTRUCT\n a : INT := 5;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  EXPECT_EQ(plc->download(compileAwl(
                data + added + withFc50("100") + ob(35, "L 1; T MW 30;") + ob(1, "CALL FC 50;"),
                model())),
            "");
  plc->settle();
  EXPECT_EQ(plc.read("MW 4"), 1u);  // the cycle ends with the old block
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MW 2"), 101u);
  EXPECT_EQ(plc.read("MW 4"), 101u);
  EXPECT_EQ(plc.read("DB1.DBW 0"), 9u);  // unchanged: keeps its values
  EXPECT_NE(plc->cpu().machine().dataBlocks.find(2), nullptr);
  plc.run(Duration::milliseconds(150));
  EXPECT_EQ(plc.read("MW 30"), 1u);  // a new OB 35 is called
}

TEST(Download, DeletedBlocksAreMissed) {
  Plc plc(withFc50("1") + ob(1, "UC FC 50;"));
  plc.cycles(2);
  EXPECT_EQ(plc->download(compileAwl(ob(1, "UC FC 50;"), model())), "");
  plc->advanceCycles(2);
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_TRUE(plc.hasEvent(0x253C));
}

// S7-SIM-11, S7-MEM-05: with the reason.
TEST(Download, IsRefused) {
  CpuParameters parameters = defaults();
  parameters.protection = 2;
  parameters.password = "secret";
  Plc plc(ob(1, ""), model(), parameters);
  const auto program = compileAwl(ob(1, "L 1; T MW 0;"), model());
  EXPECT_NE(plc->download(program).find("protection level 2"), std::string::npos);
  plc->setSwitch(cpu::SwitchPosition::Run);
  EXPECT_NE(plc->download(program, "secret").find("RUN-P"), std::string::npos);
  plc->setSwitch(cpu::SwitchPosition::RunP);
  EXPECT_EQ(plc->download(program, "secret"), "");
  plc.cycles(1);
  EXPECT_EQ(plc.read("MW 0"), 1u);
}

std::size_t residentBytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t total = 0, resident = 0;
  statm >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// A thousand stations in one process, each with its own state, in less than 2 GB.
TEST(Stations, AThousandFitInTwoGigabytes) {
  const auto program = compileAwl(
      ob(35, "L MW 10; + 1; T MW 10;") + ob(1, "U E 0.0; L S5T#1S; SE T 1; L MW 0; + 1; T MW 0;"),
      model());
  std::vector<Station> stations;
  for (int i = 0; i < 1'000; ++i) {
    stations.emplace_back(Options{.program = program});
    stations.back().warmRestart();
    stations.back().advanceCycles(static_cast<std::uint64_t>(i % 7 + 1));
  }
  for (int i = 0; i < 1'000; ++i)
    EXPECT_EQ(stations[static_cast<std::size_t>(i)].cycles(),
              static_cast<std::uint64_t>(i % 7 + 1));
  EXPECT_LT(residentBytes(), std::size_t{2} << 30);
}

}  // namespace
}  // namespace merker::station::test
