// Wrong configurations: each is one clear problem with its place in merker.toml.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "project/settings.h"

namespace merker::project {
namespace {

struct Wrong {
  std::string_view name;
  std::string_view text;     // merker.toml
  std::string_view problem;  // "line:column code"
  std::string_view words;    // that the message contains
};

// Modules that are right, for what goes wrong beside them.
#define DI16 "[[module]]\nslot = 4\ntype = \"6ES7 321-1BH02-0AA0\"\n"
#define DI_INTERRUPT "[[module]]\nslot = 4\ntype = \"6ES7 321-7BH01-0AB0\"\n"
#define DO_DIAGNOSTIC "[[module]]\nslot = 4\ntype = \"6ES7 322-8BF00-0AB0\"\n"
#define AI8 "[[module]]\nslot = 4\ntype = \"6ES7 331-7KF02-0AB0\"\n"
#define AO4 "[[module]]\nslot = 4\ntype = \"6ES7 332-5HD01-0AB0\"\n"
#define IM360 "[[module]]\nslot = 3\ntype = \"IM 360 sender\"\n"

// S7-HWCFG-07, S7-HWCFG-08, S7-HWCFG-09
constexpr Wrong kWrong[] = {
    // which module
    {"noType", "[[module]]\nslot = 4\n", "1:1 P0722", "type"},
    {"noSlot", "[[module]]\ntype = \"SM 338\"\n", "1:1 P0722", "slot = 4"},
    {"unknownType", "[[module]]\nslot = 4\ntype = \"SM 399\"\n", "3:8 P0720", "SM 399"},
    {"ambiguousType", "[[module]]\nslot = 4\ntype = \"SM 323\"\n", "3:8 P0721",
     "6ES7 323-1BH01-0AA0"},
    {"typeIsNumber", "[[module]]\nslot = 4\ntype = 321\n", "3:8 P0704", "order number"},
    {"unknownKey", DI16 "adress = 0\n", "4:1 P0703", "input"},
    {"moduleIsTable", "[module]\nslot = 4\n", "1:2 P0704", "[[module]]"},
    // where
    {"slotIsWord", "[[module]]\nslot = \"four\"\ntype = \"SM 338\"\n", "2:8 P0704", "2.2"},
    {"slot0", "[[module]]\nslot = 0\ntype = \"SM 338\"\n", "2:8 P0723", "slots 1 to 11"},
    {"ninthModule", "[[module]]\nslot = 12\ntype = \"SM 338\"\n", "2:8 P0723", "8 modules"},
    {"slotOfCpu", "[[module]]\nslot = 2\ntype = \"SM 338\"\n", "2:8 P0727", "CPU"},
    {"moduleInSlot3", "[[module]]\nslot = 3\ntype = \"SM 338\"\n", "2:8 P0726", "slots 4 to 11"},
    {"powerSupplyInSlot4", "[[module]]\nslot = 4\ntype = \"PS 307 5A\"\n", "2:8 P0726", "slot 1"},
    {"slotTwice", DI16 DI16, "5:8 P0725", "SM 321"},
    {"gap", DI16 "[[module]]\nslot = 6\ntype = \"SM 338\"\n", "5:8 P0732", "slot 5 is empty"},
    {"rackOfCpu", "[[module]]\nrack = 4\nslot = 4\ntype = \"SM 338\"\n", "2:8 P0724",
     "racks 0 to 3"},
    {"rackOf312C", "[cpu]\nmodel = \"312C\"\n[[module]]\nrack = 1\nslot = 4\ntype = \"SM 338\"\n",
     "4:8 P0724", "only rack 0"},
    {"noInterfaceModules", "[[module]]\nrack = 1\nslot = 4\ntype = \"SM 338\"\n", "2:8 P0729",
     "IM 360"},
    {"noReceiver", IM360 "[[module]]\nrack = 1\nslot = 4\ntype = \"SM 338\"\n", "5:8 P0729",
     "IM 361"},
    {"receiverInRack0", "[[module]]\nslot = 3\ntype = \"IM 361\"\n", "1:1 P0728", "racks 1 to 3"},
    {"longCable", "[[module]]\nslot = 3\ntype = \"IM 360\"\ncable = \"11m\"\n", "4:9 P0730",
     "10 m"},
    {"noCable", "[[module]]\nslot = 3\ntype = \"IM 360\"\ncable = \"0m\"\n", "4:9 P0730",
     "longer than 0 m"},
    {"rackGap", IM360 "[[module]]\nrack = 2\nslot = 3\ntype = \"IM 361\"\n", "5:8 P0749",
     "rack 1 is missing"},
    {"functionModuleBehindIm365",
     "[[module]]\nslot = 3\ntype = \"IM 365\"\n[[module]]\nrack = 1\nslot = 3\ntype = \"IM 365\"\n"
     "[[module]]\nrack = 1\nslot = 4\ntype = \"FM 351\"\n",
     "9:8 P0728", "no communication bus"},
    {"cableOfSm", DI16 "cable = \"5m\"\n", "4:1 P0735", "interface"},
    {"noSubModule", "[[module]]\nslot = 2.6\n", "2:8 P0743", "2.5 Position"},
    {"typeOfSubModule", "[[module]]\nslot = \"2.2\"\ntype = \"SM 338\"\n", "3:8 P0704",
     "must be omitted"},
    {"nameTwice", DI16 "name = \"a\"\n[[module]]\nslot = 5\ntype = \"SM 338\"\nname = \"A\"\n",
     "5:1 P0742", "slot 4"},
    // addresses
    {"overlap", DI16 "[[module]]\nslot = 5\ntype = \"6ES7 321-1BH02-0AA0\"\ninput = 1\n",
     "7:9 P0733", "0 to 1"},
    {"onBoardOverlap", DI16 "input = 125\n", "4:9 P0733", "DI24/DO16"},
    {"beyondTheArea", DI16 "input = 1023\n", "4:9 P0734", "0 to 1023"},
    {"outputOfInputs", DI16 "output = 0\n", "4:1 P0735", "no outputs"},
    {"oddAnalogAddress", AI8 "input = 257\n", "4:9 P0750", "257 of slot 4"},
    {"oddOnBoardAddress", "[[module]]\nslot = 2.3\noutput = 801\n", "3:10 P0750", "AI5/AO2"},
    {"negativeAddress", DI16 "input = -1\n", "4:9 P0704", "0 to 65535"},
    // parameters
    {"delayOfFixed", DI16 "input_delay = \"3ms\"\n", "4:1 P0735", "input delay"},
    {"delay", DI_INTERRUPT "input_delay = \"4ms\"\n", "4:15 P0737", "0.1ms, 0.5ms, 3ms"},
    {"edgesWithoutInterrupt", DI16 "rising_edge = [0]\n", "4:1 P0735", "hardware interrupts"},
    {"edgeOfNoChannel", "[[module]]\nslot = 2.2\nrising_edge = [0, 24]\n", "3:19 P0738",
     "channels 0 to 23"},
    {"edgesOfHalfAGroup", DI_INTERRUPT "rising_edge = [0]\n", "4:15 P0739", "0 and 1"},
    {"noDiagnostics", DI16 "diagnostics = true\n", "4:1 P0735", "diagnostic interrupt"},
    {"diagnosticsIsWord", AI8 "diagnostics = \"yes\"\n", "4:15 P0704", "true or false"},
    {"rangeOfDigital", DI16 "range = \"±10V\"\n", "4:1 P0735", "analog"},
    {"range", AI8 "range = \"0..5V\"\n", "4:9 P0737", "±80mV"},
    {"onStop", DO_DIAGNOSTIC "on_stop = \"hold\"\n", "4:11 P0704", "keep"},
    {"onStopOfPlain", "[[module]]\nslot = 4\ntype = \"6ES7 322-1BH01-0AA0\"\non_stop = \"keep\"\n",
     "4:1 P0735", "0 in STOP"},
    {"substituteWithoutOnStop", DO_DIAGNOSTIC "substitute = [0]\n", "4:1 P0744", "on_stop"},
    // channels
    {"channelOfNoSide", AI8 "[[module.channel]]\nrange = \"±1V\"\n", "4:1 P0744", "input = NUMBER"},
    {"keyOfChannel", AI8 "[[module.channel]]\ninput = 0\nrnge = \"±1V\"\n", "6:1 P0703",
     "valid keys in [[module.channel]]"},
    {"rangesOfAGroup",
     AI8 "[[module.channel]]\ninput = 2\nrange = \"4..20mA\"\n[[module.channel]]\ninput = 3\n"
         "range = \"Pt100\"\n",
     "9:9 P0751", "channels 2 and 3"},
    {"rangeOfHalfAGroup", AI8 "[[module.channel]]\ninput = 1\nrange = \"4..20mA\"\n", "6:9 P0751",
     "channels 0 and 1"},
    {"channelMissing", AI8 "[[module.channel]]\ninput = 8\n", "5:9 P0738", "0 to 7"},
    {"channelOfDigital", DI16 "[[module.channel]]\ninput = 0\n", "5:9 P0738", "no analog inputs"},
    {"channelTwice", AI8 "[[module.channel]]\ninput = 0\n[[module.channel]]\ninput = 0\n",
     "7:9 P0745", "channel 0"},
    {"channelRange", "[[module]]\nslot = 2.3\n[[module.channel]]\ninput = 4\nrange = \"±10V\"\n",
     "5:9 P0737", "Pt100"},
    {"limitOfNoLimits", AI8 "[[module.channel]]\ninput = 1\nupper_limit = \"5V\"\n", "6:1 P0735",
     "limits"},
    {"limitWithoutUnit", AI8 "[[module.channel]]\ninput = 0\nupper_limit = \"5\"\n", "6:15 P0740",
     "amount in V"},
    {"limitBeyondRange", AI8 "[[module.channel]]\ninput = 0\nupper_limit = \"11V\"\n", "6:15 P0741",
     "-10V to 10V"},
    {"limitsCrossed",
     AI8 "[[module.channel]]\ninput = 0\nupper_limit = \"1V\"\nlower_limit = \"2V\"\n",
     "7:15 P0741", "below its upper_limit"},
    {"wireBreakOfVolts", AI8 "[[module.channel]]\ninput = 0\nwire_break = true\n", "6:1 P0744",
     "4..20mA"},
    {"keyOfOutput", AO4 "[[module.channel]]\noutput = 0\nupper_limit = \"5V\"\n", "6:1 P0703",
     "substitute"},
    {"substituteOfChannel", AO4 "[[module.channel]]\noutput = 0\nsubstitute = \"5V\"\n",
     "6:1 P0744", "on_stop"},
    // CPU
    {"cycleMonitoring", "[cpu]\ncycle_monitoring = \"7s\"\n", "2:20 P0704", "\"6s\""},
    {"cycleMonitoringIsNumber", "[cpu]\ncycle_monitoring = 150\n", "2:20 P0704", "a duration"},
    {"minimumCycle", "[cpu]\nminimum_cycle = \"150ms\"\n", "2:17 P0704", "150 ms"},
    {"communicationLoad", "[cpu]\ncommunication_load = 60\n", "2:22 P0704", "10 to 50"},
    {"clockMemory", "[cpu]\nclock_memory = 256\n", "2:16 P0704", "0 to 255"},
    {"retentiveFlags", "[cpu]\nretentive_flags = 257\n", "2:19 P0704", "0 to 256"},
    {"protection", "[cpu]\nprotection = 4\n", "2:14 P0704", "1 to 3"},
    {"noPassword", "[cpu]\nprotection = 2\n", "2:14 P0744", "password"},
    {"imageErrors", "[cpu]\nimage_errors = \"always\"\n", "2:16 P0704", "each cycle"},
    {"noSuchOb", "[cpu.OB36]\ninterval = \"50ms\"\n", "1:6 P0746", "OB 36"},
    {"noInterval", "[cpu.OB35]\nphase = \"1ms\"\n", "1:6 P0744", "interval"},
    {"halfMillisecond", "[cpu.OB35]\ninterval = \"1.5ms\"\n", "2:12 P0704", "milliseconds"},
    {"halfMillisecondOfPhase", "[cpu.OB35]\ninterval = \"5ms\"\nphase = \"0.5ms\"\n", "3:9 P0704",
     "milliseconds"},
    {"halfMillisecondOfCycle", "[cpu]\nminimum_cycle = \"2.5ms\"\n", "2:17 P0704", "milliseconds"},
    {"phase", "[cpu.OB35]\ninterval = \"5ms\"\nphase = \"5ms\"\n", "3:9 P0704", "shorter"},
    {"period", "[cpu.OB10]\nperiod = \"second\"\n", "2:10 P0704", "minute"},
    {"startOfOb10", "[cpu.OB10]\nstart = 5\n", "2:9 P0704", "DT#"},
    // the project's choices
    {"checkAddresses", "[hardware]\ncheck_addresses = \"yes\"\n", "2:19 P0704", "standard"},
    {"mounting", "[hardware]\nmounting = \"upside down\"\n", "2:12 P0704", "vertical"}};

class WrongConfiguration : public testing::TestWithParam<Wrong> {};

TEST_P(WrongConfiguration, isOneProblemWithItsPlace) {
  Problems problems;
  readSettings(source::SourceFile("merker.toml", std::string(GetParam().text)), problems);
  ASSERT_EQ(problems.size(), 1u) << (problems.empty() ? "" : problems.list()[1].message);
  const Problem& problem = problems.list()[0];
  EXPECT_EQ(fmt::format("{}:{} {}", problem.position.line, problem.position.column, problem.name()),
            GetParam().problem)
      << problem.message;
  EXPECT_NE(problem.message.find(GetParam().words), std::string::npos) << problem.message;
  EXPECT_EQ(problem.position.file, "merker.toml");
}

INSTANTIATE_TEST_SUITE_P(Toml, WrongConfiguration, testing::ValuesIn(kWrong),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

}  // namespace
}  // namespace merker::project
