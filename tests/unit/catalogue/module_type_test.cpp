#include "catalogue/module_type.h"

#include <gtest/gtest.h>

#include <set>

namespace merker {
namespace {

const ModuleType& only(std::string_view name) {
  const auto found = findModuleTypes(name);
  EXPECT_EQ(found.size(), 1u) << name;
  return *found.at(0);
}

// S7-HW-05: three power supplies
TEST(ModuleType, powerSupplies) {
  EXPECT_EQ(findModuleTypes("PS 307").size(), 3u);
  EXPECT_EQ(only("PS 307 5A").orderNumber, "6ES7 307-1EA01-0AA0");
}

// S7-HW-01, S7-HW-06: several types of each family, each with channels and signal voltage
TEST(ModuleType, familiesHaveTypesWithChannelsAndVoltage) {
  for (const std::string_view family :
       {"SM 321", "SM 322", "SM 323", "SM 331", "SM 332", "SM 334"}) {
    const auto types = findModuleTypes(family);
    EXPECT_GE(types.size(), 2u) << family;
    for (const ModuleType* type : types) {
      EXPECT_GT(
          type->digitalInputs + type->digitalOutputs + type->analogInputs + type->analogOutputs, 0)
          << title(*type);
      EXPECT_FALSE(type->signal.empty()) << title(*type);
      EXPECT_LE(type->inputBytes, type->analogAddresses() ? 16 : 4) << title(*type);  // S7-HW-26
    }
  }
  EXPECT_EQ(only("6ES7 321-1EL00-0AA0").signal, "AC 120 V");
}

// S7-HW-07, S7-HW-08, S7-HW-09: 16 bytes of address space
TEST(ModuleType, positionAndPlaceholders) {
  EXPECT_EQ(only("SM 338").inputBytes, 16);
  EXPECT_EQ(only("SM 338").outputBytes, 0);
  for (const std::string_view name : {"FM 351", "FM 352", "FM 355 C", "FM 357-2", "CP 342-5"}) {
    EXPECT_TRUE(only(name).placeholder()) << name;
    EXPECT_EQ(only(name).inputBytes, 16) << name;
    EXPECT_TRUE(only(name).signalModule()) << name;
  }
}

// S7-HW-10
TEST(ModuleType, interfaceModules) {
  for (const std::string_view name : {"IM 360", "IM 361", "IM 365"})
    EXPECT_EQ(only(name).kind, ModuleKind::Interface);
}

TEST(ModuleType, foundByAnyWriting) {
  EXPECT_EQ(&only("6es73211bh02-0aa0"), &only("SM 321 DI16xDC24V"));
  EXPECT_EQ(&only("sm321di16xdc24v"), &only("6ES7 321-1BH02-0AA0"));
  EXPECT_EQ(findModuleTypes("SM 321 DI16").size(), 3u);
  EXPECT_TRUE(findModuleTypes("SM 399").empty());
  EXPECT_TRUE(findModuleTypes("").empty());
}

TEST(ModuleType, orderNumbersAndTitlesAreUnique) {
  std::set<std::string> seen;
  for (const ModuleType& type : moduleTypes()) {
    EXPECT_TRUE(seen.insert(std::string(type.orderNumber)).second) << type.orderNumber;
    EXPECT_TRUE(seen.insert(title(type)).second) << title(type);
  }
}

// S7-CPU-15, S7-CPU-16, S7-CPU-17
TEST(ModuleType, onBoardOfThe314C) {
  const CpuModel& cpu = defaultCpuModel();
  EXPECT_EQ(onBoardType(cpu, 2)->text, "DI24/DO16");
  EXPECT_EQ(onBoardType(cpu, 2)->inputBytes, 3);
  EXPECT_EQ(onBoardType(cpu, 2)->outputBytes, 2);
  EXPECT_EQ(onBoardType(cpu, 3)->text, "AI5/AO2");
  EXPECT_EQ(onBoardType(cpu, 4)->text, "Count");
  EXPECT_EQ(onBoardType(cpu, 5)->text, "Position");
  EXPECT_EQ(onBoardType(cpu, 6), nullptr);
}

TEST(ModuleType, onBoardOfOtherModels) {
  EXPECT_EQ(onBoardType(*findCpuModel("312C"), 2)->text, "DI10/DO6");
  EXPECT_EQ(onBoardType(*findCpuModel("312C"), 3), nullptr);
  EXPECT_EQ(onBoardType(*findCpuModel("313C-2 DP"), 2)->text, "DI16/DO16");
  EXPECT_EQ(onBoardType(*findCpuModel("313C"), 5), nullptr);
  for (unsigned subslot = 2; subslot <= 5; ++subslot)
    EXPECT_EQ(onBoardType(*findCpuModel("318-2"), subslot), nullptr);
}

}  // namespace
}  // namespace merker
