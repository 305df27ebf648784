// HALT of a control: machine code of this computer, memory reset, partner.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "control/cnc.h"
#include "step5/compiler.h"

namespace merker::cnc {
namespace {

constexpr mc5::BlockId kWork{mc5::BlockType::Pb, 1};

Instant msec(std::int64_t milliseconds) { return {milliseconds * 1'000'000}; }

class Stopper : public sinumerik::Probe {
 public:
  explicit Stopper(std::uint32_t offset) : offset_(offset) {}
  bool before(const sinumerik::Machine&, const sinumerik::CodePlace& place) override {
    if (place.offset != offset_ || !armed) return false;
    armed = false;
    return true;
  }
  void after(const sinumerik::Machine&, const sinumerik::CodePlace& place,
             const sinumerik::Passed& passed) override {
    seen.push_back(fmt::format("{}: {:08X} {:08X} {:08b}", place.offset, passed.registers.akku1,
                               passed.registers.akku2, passed.registers.displays.byte()));
  }
  bool armed = true;
  std::vector<std::string> seen;

 private:
  std::uint32_t offset_;
};

Options optionsOf(const std::string& text, bool compiled = false) {
  Options options;
  options.compiled = compiled;
  options.plc.program = step5::compile({source::SourceFile("a.s5", text)}, false, {}).program;
  EXPECT_FALSE(options.plc.program.empty());
  return options;
}

constexpr const char* kCounting =
    "OB 1\n L MW 100\n L KF +1\n +F\n T MW 100\n SPA PB 1\n SPA PB 2\n BE\n"
    "PB 1\n L MW 102\n L MW 100\n +F\n T MW 102\n BE\n"
    "PB 2\n L MW 104\n L KF +3\n +F\n T MW 104\n BE\n";

unsigned flags(const Cnc& control, unsigned word) {
  address::Reference reference;
  reference.operand = address::memory(Area::Flag, Width::Word, bitAddress(word));
  return control.read(reference).value_or(0xDEAD);
}

std::string stateOf(const Cnc& control) {
  const sinumerik::Machine& m = control.plc().machine();
  std::string text =
      fmt::format("{} {} {}", control.now().ns, control.cycles(), control.instructions());
  for (const std::uint8_t byte : m.flags) text += fmt::format(" {:02X}", byte);
  for (const sinumerik::Level& level : m.levels)
    text += fmt::format(" {} {:X}", level.frames.back().next, level.registers.akku1);
  return text;
}

// A held block is the processor's; everything is as without machine code.
TEST(Halt, isTheSameWithMachineCode) {
  if (!Cnc::canCompile()) GTEST_SKIP() << "no compiler for this processor";
  std::array<std::vector<std::string>, 2> seen;
  for (const bool compiled : {false, true}) {
    Cnc control(optionsOf(kCounting, compiled));
    Stopper stopper(2);
    const auto note = [&] { seen[compiled].push_back(stateOf(control)); };
    control.start();
    control.advanceTo(msec(200));
    note();
    EXPECT_TRUE(control.plc().probe(kWork, &stopper));
    control.runTo(msec(1000));
    EXPECT_EQ(control.mode(), controller::Mode::Halt);
    note();
    control.advanceTo(msec(2000));
    note();
    EXPECT_TRUE(control.resume());
    control.advanceTo(msec(2500));
    note();
    control.plc().probe(kWork, nullptr);
    control.advanceTo(msec(3000));
    note();
    seen[compiled].insert(seen[compiled].end(), stopper.seen.begin(), stopper.seen.end());
  }
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_GT(seen[0].size(), 20u);
}

TEST(Halt, endsWithAMemoryReset) {
  Cnc control(optionsOf(kCounting));
  Stopper stopper(2);
  control.plc().probe(kWork, &stopper);
  control.start();
  control.advanceTo(msec(500));
  EXPECT_EQ(control.mode(), controller::Mode::Halt);
  EXPECT_EQ(control.stopReason(), "");
  control.memoryReset();
  EXPECT_EQ(control.mode(), controller::Mode::Stop);
  EXPECT_EQ(control.now(), msec(500));
  EXPECT_FALSE(control.resume());
  stopper.armed = true;  // its probe is still there
  control.start();
  control.runTo(msec(1000));
  EXPECT_EQ(control.mode(), controller::Mode::Halt);
  control.resume();
  control.advanceTo(msec(1100));
  EXPECT_EQ(control.mode(), controller::Mode::Run);
}

struct Pair {
  Pair() : control(optionsOf(kCounting)) {
    auto other = std::make_unique<Cnc>(optionsOf(kCounting));
    partner = other.get();
    control.couple(std::move(other), nc::Side::Control);
    control.start();
    partner->start();
  }
  Cnc control;
  Cnc* partner;
};

TEST(Halt, aPartnerStandsToo) {
  Pair pair, quiet;
  Stopper stopper(2);
  pair.control.advanceTo(msec(190));
  pair.control.plc().probe(kWork, &stopper);
  pair.control.advanceTo(msec(5000));
  EXPECT_EQ(pair.control.mode(), controller::Mode::Halt);
  EXPECT_EQ(pair.partner->mode(), controller::Mode::Halt);
  EXPECT_EQ(pair.partner->now(), msec(5000));
  EXPECT_EQ(pair.partner->cycles(), 4u);
  EXPECT_TRUE(pair.control.settle(Duration::seconds(1)));
  const Instant since = *pair.control.plc().heldSince();
  quiet.control.advanceTo(since);
  EXPECT_EQ(pair.partner->instructions(), quiet.partner->instructions());
  pair.control.resume();
  EXPECT_EQ(pair.partner->mode(), controller::Mode::Run);
  pair.control.advanceTo(msec(5400));
  quiet.control.advanceTo(since + Duration::milliseconds(400));
  EXPECT_EQ(flags(*pair.partner, 102), flags(*quiet.partner, 102));
  EXPECT_EQ(pair.partner->cycles(), quiet.partner->cycles());
  EXPECT_EQ(pair.control.cycles(), quiet.control.cycles());
}

TEST(Halt, aPartnerThatHoldsHoldsBoth) {
  Pair pair;
  Stopper stopper(2);
  pair.partner->plc().probe(kWork, &stopper);
  pair.control.advanceTo(msec(5000));
  EXPECT_EQ(pair.partner->mode(), controller::Mode::Halt);
  EXPECT_EQ(pair.control.mode(), controller::Mode::Halt);
  EXPECT_LE(pair.control.cycles(), 1u);
  pair.control.resume();
  pair.control.advanceTo(msec(5400));
  EXPECT_EQ(pair.partner->mode(), controller::Mode::Run);
  EXPECT_EQ(pair.partner->cycles(), 7u);
}

TEST(Halt, aPartnerGoesOnAfterAStop) {
  Pair pair;
  EXPECT_TRUE(pair.control.hold());
  EXPECT_EQ(pair.partner->mode(), controller::Mode::Halt);
  pair.control.advanceTo(msec(1000));
  pair.control.stop();
  EXPECT_EQ(pair.control.mode(), controller::Mode::Stop);
  EXPECT_EQ(pair.partner->mode(), controller::Mode::Run);
  pair.control.advanceTo(msec(1200));
  EXPECT_EQ(pair.partner->cycles(), 4u);
}

}  // namespace
}  // namespace merker::cnc
