// Hardware and diagnostic interrupts of the counting channels (technology manual 5.8.3, 5.8.4).
#include <gtest/gtest.h>

#include "counting_plc.h"

namespace merker::station::test {
namespace {

// Counts its calls in MW 10 and keeps OB40_POINT_ADDR of the last two in MD 12 and MD 16.
std::string interruptProgram(std::string_view wait = "") {
  return ob(40, "L MW 10; + 1; T MW 10; L MD 12; T MD 16; L LD 8; T MD 12; L LW 6; T MW 20;" +
                    std::string(wait));
}

// CNT-PRAL-01, CNT-PARAM-02: both the selection and the cause.
TEST(CountingInterrupts, SelectionAndCause) {
  for (const bool selected : {false, true})
    for (const bool cause : {false, true}) {
      Counting c(
          47,
          [&](io::Parameters& p, io::Module&) {
            p.hardwareInterrupt = selected;
            p.counters[0] = channel(CountMode::Endless);
            p.counters[0].onCountEdge = cause;
          },
          interruptProgram());
      c.set("SW_GATE", 1);
      c.wait(5);
      c.pulses(0, 3);
      c.wait(50);
      EXPECT_EQ(c.plc.read("MW 10"), selected && cause ? 3u : 0u);
      EXPECT_EQ(c.plc->mode(), Mode::Run);
    }
}

// CNT-PRAL-01, CNT-DIAG-06: without the OB the CPU stops.
TEST(CountingInterrupts, WithoutTheirOb) {
  const auto edges = [](io::Parameters& p, io::Module&) {
    p.hardwareInterrupt = p.diagnosticInterrupt = true;
    p.counters[0] = channel(CountMode::Endless);
    p.counters[0].onCountEdge = true;
  };
  Counting without40(47, edges);
  without40.set("SW_GATE", 1);
  without40.wait(5);
  without40.pulses(0, 1);
  without40.wait(50);
  EXPECT_EQ(without40.plc->mode(), Mode::Stop);
  Counting without82(47, edges, interruptProgram("CALL SFC 47 (WT := 20000);"));
  without82.set("SW_GATE", 1);
  without82.wait(5);
  without82.pulses(0, 3, 200);  // the second and third come while OB 40 runs
  without82.wait(50);
  EXPECT_EQ(without82.plc->mode(), Mode::Stop);
  EXPECT_FALSE(without82.plc->diagnostics().empty());
}

// CNT-PRAL-02, CNT-PRAL-03, CNT-PRAL-04: where each cause of each channel stands.
TEST(CountingInterrupts, PointsOfCounting) {
  constexpr std::uint32_t kInputs[] = {0, 3, 6, 9}, kGates[] = {2, 5, 8, 11};
  constexpr std::uint32_t kHalfByte[] = {24, 28, 16, 20}, kEdge[] = {8, 12, 0, 4};
  for (std::uint32_t number = 0; number < 4; ++number) {
    Counting c(
        47,
        [&](io::Parameters& p, io::Module&) {
          p.hardwareInterrupt = true;
          CountChannel& n = p.counters[number] = channel(CountMode::Periodic);
          n.direction = io::CountDirection::Forward;
          n.endValue = 3;
          n.comparison = 1;
          n.output = io::CountOutput::AtLeast;
          n.hardwareGate = n.onGateOpened = n.onGateClosed = n.onComparator = n.onOverflow = true;
          n.onCountEdge = number == 3;
        },
        interruptProgram());
    c.set("CHANNEL", number);
    c.set("SW_GATE", 1);
    c.wait(5);
    const std::uint32_t shift = kHalfByte[number];
    const std::uint32_t edge = number == 3 ? 1u << kEdge[number] : 0u;
    c.input(kGates[number], true);
    c.wait(5);
    EXPECT_EQ(c.plc.read("MD 12"), 1u << shift);
    EXPECT_EQ(c.plc.read("MW 20"), 768u);
    c.pulses(kInputs[number], 1);
    c.wait(20);
    EXPECT_EQ(c.plc.read("MD 12"), 8u << shift | edge);
    c.pulses(kInputs[number], 2);
    c.wait(30);
    EXPECT_EQ(c.plc.read("MD 12"), 4u << shift | edge);
    c.input(kGates[number], false);
    c.wait(5);
    EXPECT_EQ(c.plc.read("MD 12"), 2u << shift);
  }
}

// CNT-PRAL-05, CNT-PRAL-06
TEST(CountingInterrupts, PointsOfTheOthers) {
  Counting frequency(
      48,
      [](io::Parameters& p, io::Module&) {
        p.hardwareInterrupt = true;
        p.counters[2] = channel(CountMode::Frequency);
        p.counters[2].onMeasured = true;
      },
      interruptProgram());
  frequency.set("CHANNEL", 2);
  frequency.set("SW_GATE", 1);
  frequency.wait(120);
  EXPECT_EQ(frequency.plc.read("MD 12"), 0x00080000u);
  Counting pwm(
      49,
      [](io::Parameters& p, io::Module&) {
        p.hardwareInterrupt = true;
        p.counters[3] = channel(CountMode::PulseWidth);
        p.counters[3].hardwareGate = p.counters[3].onGateOpened = true;
      },
      interruptProgram());
  pwm.set("CHANNEL", 3);
  pwm.set("SW_EN", 1);
  pwm.wait(5);
  pwm.input(11, true);
  pwm.wait(5);
  EXPECT_EQ(pwm.plc.read("MD 12"), 0x00100000u);
}

// CNT-PRAL-11: the jump to the load value is the comparison value as well.
TEST(CountingInterrupts, OneCallForOneInstant) {
  Counting c(
      47,
      [](io::Parameters& p, io::Module&) {
        p.hardwareInterrupt = true;
        CountChannel& n = p.counters[0] = channel(CountMode::Periodic);
        n.direction = io::CountDirection::Forward;
        n.endValue = 3;
        n.output = io::CountOutput::Pulse;
        n.pulseDuration = 2;
        n.onComparator = n.onOverflow = true;
      },
      interruptProgram());
  c.set("SW_GATE", 1);
  c.wait(5);
  c.pulses(0, 3);
  c.wait(50);
  EXPECT_EQ(c.plc.read("MW 10"), 1u);
  EXPECT_EQ(c.plc.read("MD 12"), 0x0C000000u);
}

// CNT-SIM-03: OB 40 begins at the instant of its cause, again and again the same.
TEST(CountingInterrupts, BeginAtTheInstantOfTheirCause) {
  std::vector<std::uint32_t> first;
  for (int run = 0; run < 3; ++run) {
    Counting c(
        47,
        [](io::Parameters& p, io::Module&) {
          p.hardwareInterrupt = true;
          p.counters[0] = channel(CountMode::Endless);
          p.counters[0].onCountEdge = true;
        },
        ob(40,
           "L MW 10; SLW 2; SLD 3; LAR1; CALL SFC 64 (RET_VAL := MD 60); L MD 60; T MD [AR1, "
           "P#100.0];"
           "L MW 10; + 1; T MW 10;"));
    c.set("SW_GATE", 1);
    c.wait(5);
    const std::int64_t start = c.plc->now().ns;
    signal::Pulses p = signal::pulsesOf(100'000, 500, c.plc->now());
    p.count = 20;
    p.jitter = 200;
    const signal::PulseTrain train(p);
    c.plc->rack()->attach(*c.plc->rack()->terminal("2.2", io::Side::DigitalInput, 0),
                          std::make_shared<signal::PulseTrain>(train), c.plc->now());
    c.wait(300);
    std::vector<std::uint32_t> ticks;
    for (int i = 0; i < 20; ++i) ticks.push_back(c.plc.read("MD " + std::to_string(100 + 4 * i)));
    Instant edge{start - 1};
    constexpr std::int64_t kFilter = 480'000, kMillisecond = 1'000'000;
    for (const std::uint32_t tick : ticks) {
      edge = train.next(edge);
      EXPECT_NEAR(static_cast<double>(tick),
                  static_cast<double>((edge.ns + kFilter) / kMillisecond), 1);
      edge = train.next(edge);  // the falling one
    }
    if (run == 0) first = ticks;
    EXPECT_EQ(ticks, first);
  }
}

// CNT-PRAL-12: another cause waits until OB 40 has ended; nothing is lost.
TEST(CountingInterrupts, AnotherCauseWaits) {
  Counting c(
      47,
      [](io::Parameters& p, io::Module&) {
        p.hardwareInterrupt = p.diagnosticInterrupt = true;
        p.counters[0] = channel(CountMode::Endless);
        p.counters[0].onCountEdge = true;
        p.counters[1] = channel(CountMode::Endless);
        p.counters[1].hardwareGate = p.counters[1].onGateOpened = true;
      },
      interruptProgram("CALL SFC 47 (WT := 20000);") + ob(82, "SET; S M 1.0;"));
  c.set("SW_GATE", 1);
  c.wait(5);
  c.set("CHANNEL", 1);
  c.wait(5);
  c.pulses(0, 1);
  c.pulses(5, 1, 100, 8);  // while OB 40 runs
  c.wait(60);
  EXPECT_EQ(c.plc.read("MW 10"), 2u);
  EXPECT_EQ(c.plc.read("MD 16"), 0x00000100u);
  EXPECT_EQ(c.plc.read("MD 12"), 0x10000000u);
  EXPECT_EQ(c.plc.read("M 1.0"), 0u);
}

// CNT-DIAG-01: the parametrising error comes and goes with OB 82, if the interrupt selection says
// so.
TEST(CountingInterrupts, ParameterErrorAsDiagnosis) {
  for (const bool selected : {false, true}) {
    Counting c(
        47,
        [&](io::Parameters& p, io::Module&) {
          p.diagnosticInterrupt = selected;
          p.counters[0] = channel(CountMode::Endless);
        },
        ob(82, "L MW 10; + 1; T MW 10; L LB 0; T MB 12;"));
    const auto module = c.plc->rack()->module("2.4");
    ASSERT_TRUE(module);
    c.plc->rack()->fault(*module, io::FaultKind::ParameterError, std::nullopt, true);
    c.wait(20);
    EXPECT_EQ(c.plc.read("MW 10"), selected ? 1u : 0u);
    EXPECT_EQ(c.plc.read("MB 12"), selected ? 0x39u : 0u);  // coming
    c.plc->rack()->fault(*module, io::FaultKind::ParameterError, std::nullopt, false);
    c.wait(20);
    EXPECT_EQ(c.plc.read("MW 10"), selected ? 2u : 0u);
    EXPECT_EQ(c.plc.read("MB 12"), selected ? 0x38u : 0u);  // going
    EXPECT_EQ(c.plc->mode(), Mode::Run);
  }
}

// CNT-GATE-11: in STOP the internal gate is closed and the output 0; pulses do not count.
TEST(CountingInterrupts, NothingCountsInStop) {
  Counting c(47, [](io::Parameters& p, io::Module&) {
    p.counters[0] = channel(CountMode::Endless);
    p.counters[0].output = io::CountOutput::AtLeast;
    p.counters[0].comparison = 2;
  });
  c.set("CTRL_DO", 1);
  c.set("SW_GATE", 1);
  c.wait(5);
  c.pulses(0, 3);
  c.wait(100);
  EXPECT_EQ(c.read("COUNTVAL"), 3u);
  EXPECT_TRUE(c.output(0));
  c.plc->stop();
  c.wait(5);
  EXPECT_FALSE(c.output(0));
  c.pulses(0, 5);
  c.wait(200);
  EXPECT_EQ(c.plc.read("PED 768"), 3u);
}

}  // namespace
}  // namespace merker::station::test
