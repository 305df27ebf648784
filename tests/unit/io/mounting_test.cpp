#include <gtest/gtest.h>

#include "make.h"

namespace merker::io {
namespace {

using Codes = std::vector<std::string>;

// S7-HW-12
TEST(Mounting, slots) {
  EXPECT_EQ(problemsOf({make(0, 2, "SM 321 DI16xDC24V")}), Codes{"P0727"});
  EXPECT_EQ(problemsOf({make(0, 3, "SM 321 DI16xDC24V")}), Codes{"P0726"});
  EXPECT_EQ(problemsOf({make(0, 4, "PS 307 5A")}), Codes{"P0726"});
  EXPECT_EQ(problemsOf({make(0, 4, "IM 360")}), Codes{"P0726"});
  EXPECT_EQ(problemsOf({make(0, 0, "SM 321 DI16xDC24V")}), Codes{"P0723"});
  good({make(0, 1, "PS 307 5A"), make(0, 4, "SM 321 DI16xDC24V")});
}

// S7-HW-13: a ninth module has no slot
TEST(Mounting, eightModulesARack) {
  EXPECT_EQ(problemsOf({make(0, 12, "SM 321 DI16xDC24V")}), Codes{"P0723"});
}

TEST(Mounting, oneModuleASlot) {
  EXPECT_EQ(problemsOf({make(0, 4, "SM 321 DI16xDC24V"), make(0, 4, "SM 322 DO16xDC24V/0.5A")}),
            Codes{"P0725"});
}

// S7-HW-33
TEST(Mounting, gaps) {
  EXPECT_EQ(problemsOf({make(0, 4, "SM 321 DI16xDC24V"), make(0, 6, "SM 321 DI16xDC24V")}),
            Codes{"P0732"});
}

// S7-HW-14: 1.2 A in rack 0, 0.8 A in an expansion rack
TEST(Mounting, currentOfTheBackplaneBus) {
  std::vector<Module> modules;
  for (std::uint32_t slot = 4; slot <= 9; ++slot)
    modules.push_back(make(0, slot, "SM 322 DO16xAC120/230V/1A"));  // 200 mA each
  good(modules);
  modules.push_back(make(0, 10, "SM 321 DI16xDC24V"));
  EXPECT_EQ(problemsOf(modules), Codes{"P0731"});
}

TEST(Mounting, currentOfAnExpansionRack) {
  std::vector<Module> modules{make(0, 3, "IM 360"), make(1, 3, "IM 361")};
  for (std::uint32_t slot = 4; slot <= 7; ++slot)
    modules.push_back(make(1, slot, "SM 322 DO16xAC120/230V/1A"));
  good(modules);
  modules.push_back(make(1, 8, "SM 321 DI16xDC24V"));
  EXPECT_EQ(problemsOf(modules), Codes{"P0731"});
}

// S7-HW-14: 1.2 A together with IM 365
TEST(Mounting, currentOfTheIm365Pair) {
  std::vector<Module> modules{make(0, 3, "IM 365"), make(1, 3, "IM 365")};
  for (std::uint32_t slot = 4; slot <= 6; ++slot) {
    modules.push_back(make(0, slot, "SM 322 DO16xAC120/230V/1A"));
    if (slot < 6) modules.push_back(make(1, slot, "SM 322 DO16xAC120/230V/1A"));
  }
  good(modules);  // 700 + 500 mA
  modules.push_back(make(1, 6, "SM 321 DI16xDC24V"));
  EXPECT_EQ(problemsOf(modules), Codes{"P0731"});
}

// S7-HW-15, S7-HW-10
TEST(Mounting, severalRacksNeedInterfaceModules) {
  const Module io = make(1, 4, "SM 321 DI16xDC24V");
  EXPECT_EQ(problemsOf({io}), Codes{"P0729"});
  EXPECT_EQ(problemsOf({make(0, 3, "IM 360"), io}), Codes{"P0729"});
  EXPECT_EQ(problemsOf({make(1, 3, "IM 361"), io}), Codes{"P0729"});
  EXPECT_EQ(problemsOf({make(0, 3, "IM 360"), make(1, 3, "IM 365"), io}), Codes{"P0728"});
  EXPECT_EQ(problemsOf({make(0, 3, "IM 365"), make(1, 3, "IM 361"), io}), Codes{"P0728"});
  EXPECT_EQ(problemsOf({make(0, 3, "IM 361")}), Codes{"P0728"});
  EXPECT_EQ(problemsOf({make(0, 3, "IM 360"), make(1, 3, "IM 360"), io}),
            (Codes{"P0728", "P0729"}));
  EXPECT_EQ(problemsOf({make(0, 3, "IM 365"), make(1, 3, "IM 365"), io, make(2, 3, "IM 361"),
                        make(2, 4, "SM 321 DI16xDC24V")}),
            Codes{"P0728"});
  good({make(0, 3, "IM 365"), make(1, 3, "IM 365"), io});
  good({make(0, 3, "IM 360"), make(1, 3, "IM 361"), io});
}

// S7-HW-10: an IM 365 feeds signal modules; FM and CP need the communication bus.
TEST(Mounting, onlySignalModulesBehindAnIm365) {
  for (const char* type : {"FM 350-1 counter", "6GK7 342-5DA03-0XE0"}) {
    EXPECT_EQ(problemsOf({make(0, 3, "IM 365"), make(1, 3, "IM 365"), make(1, 4, type)}),
              Codes{"P0728"});
    good({make(0, 3, "IM 360"), make(1, 3, "IM 361"), make(1, 4, type)});
    good({make(0, 3, "IM 365"), make(0, 4, type), make(1, 3, "IM 365"), make(1, 4, "SM 338")});
  }
}

// S7-HW-17, S7-HW-33
TEST(Mounting, gapsBetweenRacks) {
  EXPECT_EQ(problemsOf({make(0, 3, "IM 360"), make(1, 3, "IM 361"), make(3, 3, "IM 361"),
                        make(3, 4, "SM 338")}),
            Codes{"P0749"});
  EXPECT_EQ(problemsOf({make(0, 3, "IM 360"), make(2, 3, "IM 361")}), Codes{"P0749"});
}

// S7-HW-16
TEST(Mounting, cable) {
  Module im = make(1, 3, "IM 361");
  im.cablePosition = {"merker.toml", 5, 1};
  im.cable = 10;
  good({make(0, 3, "IM 360"), im});
  for (const double wrong : {11., 0., -3.}) {
    im.cable = wrong;
    EXPECT_EQ(problemsOf({make(0, 3, "IM 360"), im}), Codes{"P0730"});
  }
}

// S7-CPU-14, S7-HW-17
TEST(Mounting, racks) {
  EXPECT_EQ(problemsOf({make(4, 4, "SM 321 DI16xDC24V")}), Codes{"P0724"});
  EXPECT_EQ(problemsOf({make(1, 2, "SM 321 DI16xDC24V")}), Codes{"P0727"});
  EXPECT_EQ(problemsOf({make(1, 4, "SM 321 DI16xDC24V")}, *findCpuModel("312C")), Codes{"P0724"});
}

// S7-CPU-12, S7-OPEN-45: 31 modules with 32 channels and 40 on board are more than 1016
TEST(Mounting, digitalChannels) {
  std::vector<Module> modules{make(0, 3, "IM 360")};
  for (std::uint32_t rack = 0; rack < 4; ++rack) {
    if (rack > 0) modules.push_back(make(rack, 3, "IM 361"));
    for (std::uint32_t slot = 4; slot <= (rack < 3 ? 11 : 9); ++slot)
      modules.push_back(make(rack, slot, "SM 321 DI32xDC24V"));
  }
  good(modules);  // 30 * 32 + 40 = 1000
  modules.push_back(make(3, 10, "SM 321 DI32xDC24V"));
  EXPECT_EQ(problemsOf(modules), Codes{"P0736"});
  modules.back() = make(3, 10, "SM 321 DI16xDC24V");
  good(modules);  // 1016
  modules.push_back(make(3, 11, "6ES7 322-8BF00-0AB0"));
  modules.back().outputStart = 200;  // its own address is that of the outputs on board
  EXPECT_EQ(problemsOf(modules), Codes{"P0736"});  // 1024
}

// S7-CPU-13, S7-OPEN-45: 7 on board and 31 modules of 8 are more than 253
TEST(Mounting, analogChannels) {
  std::vector<Module> modules{make(0, 3, "IM 360")};
  for (std::uint32_t rack = 0; rack < 4; ++rack) {
    if (rack > 0) modules.push_back(make(rack, 3, "IM 361"));
    for (std::uint32_t slot = 4; slot <= (rack < 3 ? 11 : 9); ++slot)
      modules.push_back(make(rack, slot, "6ES7 331-7KF02-0AB0"));
  }
  good(modules);  // 30 * 8 + 7 = 247
  modules.push_back(make(3, 10, "6ES7 331-7KF02-0AB0"));
  EXPECT_EQ(problemsOf(modules), Codes{"P0736"});
  modules.back() = make(3, 10, "6ES7 332-5HD01-0AB0");
  modules.push_back(make(3, 11, "6ES7 331-7KB02-0AB0"));
  modules.back().inputStart = 800;
  good(modules);  // 247 + 4 + 2 = 253
  modules.back() = make(3, 11, "6ES7 332-5HD01-0AB0");
  modules.back().outputStart = 800;
  EXPECT_EQ(problemsOf(modules), Codes{"P0736"});  // 255
}

TEST(Mounting, namesAreUnique) {
  Module one = make(0, 4, "SM 321 DI16xDC24V"), two = make(0, 5, "SM 321 DI16xDC24V");
  one.name = "Belt";
  two.name = "BELT";
  EXPECT_EQ(problemsOf({one, two}), Codes{"P0742"});
}

}  // namespace
}  // namespace merker::io
