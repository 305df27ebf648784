// GSD files of any maker (S7-NET-10: what a DP slave is): grammar, bytes, and what real
// files do wrong.
#include <gtest/gtest.h>

#include <algorithm>

#include "gsd/configuration.h"
#include "gsd/parameters.h"
#include "gsd/read.h"

namespace merker::gsd {
namespace {

Reading readText(const std::string& text) { return read(source::SourceFile("a.gsd", text)); }

// A file with these modules and nothing wrong around them.
Reading device(const std::string& text) {
  return readText("#Profibus_DP\nVendor_Name = \"Merker\"\nIdent_Number = 0x1234\n" + text);
}

std::vector<std::string> remarksOf(const Reading& reading) {
  std::vector<std::string> texts;
  for (const Remark& remark : reading.remarks)
    texts.push_back(std::to_string(remark.line) + ": " + remark.text);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(GsdRead, ADeviceSaysWhoItIsAndWhatItCan) {
  const Reading read = device(
      "GSD_Revision=5\nModel_Name = \"Valve; island\" ; a comment\nMODULAR_STATION = 1\n"
      "Max_Module = 0x20\nMax_Input_Len = 244\n9.6_supp = 1\n12M_supp = 1\n45.45_supp=0\n"
      "MaxTsdr_12M = 800\nSync_Mode_supp = 1\nSlave_Family = 3@TdF@ET 200\n");
  EXPECT_TRUE(read.isGsd);
  EXPECT_EQ(remarksOf(read), Texts{});
  EXPECT_EQ(read.device.model, "Valve; island");
  EXPECT_EQ(read.device.ident, 0x1234);
  EXPECT_TRUE(read.device.modular);
  EXPECT_TRUE(read.device.sync);
  EXPECT_FALSE(read.device.freeze);
  EXPECT_EQ(read.device.maxModules, 32);
  EXPECT_EQ(read.device.family, "3@TdF@ET 200");
  std::vector<std::int64_t> rates;
  for (const BaudRate& rate : read.device.rates)
    if (rate.supported) rates.push_back(rate.rate);
  EXPECT_EQ(rates, (std::vector<std::int64_t>{9'600, 12'000'000}));
  EXPECT_EQ(read.device.rates.back().maxTsdr, 800);
}

TEST(GsdRead, ModulesHaveBytesReferenceAndParameters) {
  const Reading read = device(
      "PrmText = 1\nText(0) = \"off\"\nText(1) = \"on\"\nEndPrmText\n"
      "ExtUserPrmData = 7 \"Filter\"\nBitArea(4-5) 2 0-3\nPrm_Text_Ref = 1\nEndExtUserPrmData\n"
      "ExtUserPrmData = 8 \"Limit\"\nSigned16 -2 -100-100\nEndExtUserPrmData\n"
      "Module = \"8 DI\" 0x10\n3\nPreset = 1\nExt_Module_Prm_Data_Len = 5\n"
      "Ext_User_Prm_Data_Const(0) = 0x11,0xFF,0x33\nExt_User_Prm_Data_Ref(1) = 7\n"
      "Ext_User_Prm_Data_Ref(3) = 8\nEndModule\n"
      "module=\"16 DO\" \\  ; goes on\n 0x21, \\\n 32\nEndModule\nModule = \"Empty\"\nEndModule\n");
  EXPECT_EQ(remarksOf(read), Texts{});
  ASSERT_EQ(read.device.modules.size(), 3u);
  const Module& first = read.device.modules[0];
  EXPECT_EQ(first.name, "8 DI");
  EXPECT_EQ(first.configuration, Bytes{0x10});
  EXPECT_EQ(first.reference, 3);
  EXPECT_TRUE(first.preset);
  EXPECT_EQ(standardParameters(first.parameters, read.device),
            (Bytes{0x11, 0xEF, 0x33, 0xFF, 0xFE}));
  EXPECT_EQ(read.device.modules[1].configuration, (Bytes{0x21, 0x20}));
  EXPECT_EQ(read.device.modules[2].configuration, Bytes{});
  EXPECT_EQ(read.device.definitions[1].allowed, (Ranges{{-100, 100}}));
  EXPECT_EQ(read.device.texts.at(1).at(1), "on");
}

TEST(GsdRead, SlotsAndTextsOfTheDiagnosis) {
  const Reading read = device(
      "SlotDefinition\nSlot(1) = \"Head\" 2 1-3,7\nEndSlotDefinition\n"
      "Unit_Diag_Bit(0x18) = \"No voltage\"\n"
      "Unit_Diag_Area = 8-11\nValue(2) = \"Short circuit\"\nUnit_Diag_Area_End\n"
      "User_Prm_Data_Len = 3\nUser_Prm_Data = 0x00,0x01,0x02\n");
  EXPECT_EQ(remarksOf(read), Texts{});
  ASSERT_EQ(read.device.slots.size(), 1u);
  EXPECT_EQ(read.device.slots[0].standard, 2);
  EXPECT_EQ(read.device.slots[0].allowed, (Ranges{{1, 3}, {7, 7}}));
  ASSERT_EQ(read.device.diagnosis.size(), 2u);
  EXPECT_EQ(read.device.diagnosis[0].firstBit, 0x18u);
  EXPECT_EQ(read.device.diagnosis[1].lastBit, 11u);
  EXPECT_EQ(read.device.diagnosis[1].value, 2);
  EXPECT_EQ(standardParameters(read.device.parameters, read.device), (Bytes{0, 1, 2}));
}

// Each is what a published file does; the module comes out nevertheless.
TEST(GsdRead, NoModuleIsLostThroughWhatAFileDoesWrong) {
  struct Row {
    std::string text, remark;
  };
  const std::string after = "Module = \"B\" 0x21\nEndModule\n";
  const Row rows[] = {
      {"Module = \"A\" 0x10\n", "4: there is no EndModule for it"},
      {"PrmText = 1\nText(0) = \"x\"\nModule = \"A\" 0x10\nEndModule\n",
       "4: there is no EndPrmText for it"},
      {"Module = \"A 0x10\nEndModule\n", "4: the text has no closing quotation mark"},
      {"Module = \"A\" 0x10 EndModule\n", ""},
      {"Module = \"A\" 0x 10\nEndModule\n", "4: there must be no blank in 0x10"},
      {"Module = \"A\"\n0x10\n1\nEndModule\n", ""},
      {"Module \"A\" 0X10\nEndModule\n", ""},
      {"Module=\"A\"0x10\nendmodule\n", ""},
      {"Module = \"A\" 16,\nEndModule\n", ""},
      {"Module = \"A\" 0x10\nEndModule\nEndModule\n", "6: EndModule ends nothing that is open"},
      {"Module = \"A\" 0x10\nExt_User_Prm_Data_Ref(0) = 9\nEndModule\n",
       "4: ExtUserPrmData 9 is not defined"},
  };
  for (const Row& row : rows) {
    const Reading read = device(row.text + after);
    ASSERT_EQ(read.device.modules.size(), 2u) << row.text;
    EXPECT_EQ(read.device.modules[0].name, "A") << row.text;
    EXPECT_EQ(read.device.modules[0].configuration, Bytes{0x10}) << row.text;
    EXPECT_EQ(read.device.modules[1].configuration, Bytes{0x21}) << row.text;
    EXPECT_EQ(remarksOf(read), row.remark.empty() ? Texts{} : Texts{row.remark}) << row.text;
  }
}

// "0x" without digits is no number, and takes none of the next line or of what is no digit.
TEST(GsdRead, WhatStandsBehindAZeroAndAnXIsItsNumber) {
  const Reading read = device(
      "Module = \"A\" 0x 1F, 0X\t2a\nEndModule\nModule = \"B\" 0x\n10\nEndModule\n"
      "Module = \"C\" 0x , 0x12\nEndModule\n");
  ASSERT_EQ(read.device.modules.size(), 3u);
  EXPECT_EQ(read.device.modules[0].configuration, (Bytes{0x1F, 0x2A}));
  EXPECT_EQ(read.device.modules[1].configuration, Bytes{});
  EXPECT_EQ(read.device.modules[2].configuration, Bytes{0x12});
}

TEST(GsdRead, AListMayGoOnWithoutItsBackslash) {
  const Reading read = device("Module = \"A\" 0x10,\n 0x20\nEndModule\n");
  EXPECT_EQ(read.device.modules[0].configuration, (Bytes{0x10, 0x20}));
  EXPECT_EQ(remarksOf(read),
            Texts{"4: the list goes on in the next line; this line must end with \\"});
  EXPECT_EQ(remarksOf(device("Module = \"A\" 0x10,\r\n\r\n0x20\r\nEndModule\r\n")).size(), 1u);
  const Reading ended = device("Module = \"A\" 0x10,\n7\nEndModule\n");
  EXPECT_EQ(ended.device.modules[0].configuration, Bytes{0x10});
  EXPECT_EQ(ended.device.modules[0].reference, 7);
  const Reading commented = device("Module = \"A\" 0x10,\\\n ; why\n 0x20\nEndModule\n");
  EXPECT_EQ(commented.device.modules[0].configuration, (Bytes{0x10, 0x20}));
  EXPECT_EQ(remarksOf(commented), Texts{});
  EXPECT_EQ(
      remarksOf(device("Module = \"A\" 0x10 0x20 0x1FF\nEndModule\n")),
      (Texts{"4: there must be a comma before 0x20", "4: '0x1FF' must be a byte, 0 to 0xFF"}));
}

TEST(GsdRead, OnlyTheSectionOfDpCounts) {
  const Reading both = readText(
      "Text in front\n#Profibus_FMS\nModule = \"F\" 0x10\n#PROFIBUS_DP\nVendor_Name = \"M\"\n"
      "Ident_Number = 1\nModule = \"D\" 0x20\nEndModule\n#Profibus_FMS\nModule = \"G\" 0x10\n");
  ASSERT_EQ(both.device.modules.size(), 1u);
  EXPECT_EQ(both.device.modules[0].name, "D");
  EXPECT_FALSE(readText("PROFIBUS is a bus\nthat is all\n").isGsd);
  const Reading bare =
      readText("Vendor_Name=\"M\"\nIdent_Number=1\nModule=\"D\" 0x20\nEndModule\n");
  EXPECT_TRUE(bare.isGsd);
  EXPECT_EQ(remarksOf(bare), Texts{"1: the line #Profibus_DP is missing"});
  EXPECT_EQ(bare.device.modules.size(), 1u);
}

TEST(GsdRead, NoEncodingHidesAModule) {
  const std::string text =
      "#Profibus_DP\nModule\xA0= \"Z\xE4hler\"\xA0"
      "0x10\nEndModule\n";
  for (const std::string& end : {std::string{}, std::string("\x1A"), std::string(200, '\0')}) {
    const Reading read = merker::gsd::read(decode("a.gsd", text + end));
    ASSERT_EQ(read.device.modules.size(), 1u);
    EXPECT_EQ(read.device.modules[0].name, "Zähler");
    EXPECT_EQ(read.device.modules[0].configuration, Bytes{0x10});
  }
}

TEST(GsdRead, WhatMustBeThereIsMissed) {
  EXPECT_EQ(remarksOf(readText("#Profibus_DP\nMax_Module = many\n")),
            (Texts{"0: Vendor_Name is missing", "0: Ident_Number is missing",
                   "2: 'Max_Module' must be a number, not 'many'"}));
}

TEST(GsdIdentifiers, SayHowManyBytes) {
  struct Row {
    Bytes bytes;
    std::uint32_t input, output;
  };
  // The last is an AS-i link with PROFIsafe: lengths, then ten bytes of its maker.
  const Row rows[] = {{{0x10}, 1, 0},
                      {{0x2F}, 0, 16},
                      {{0x33}, 4, 4},
                      {{0x50}, 2, 0},
                      {{0xF1}, 4, 4},
                      {{0x00}, 0, 0},
                      {{0x11, 0x63}, 2, 8},
                      {{0x42, 0x41, 1, 2}, 4, 0},
                      {{0x80, 0x03}, 0, 4},
                      {{0xCF, 0x00, 0x40}, 2, 1},
                      {{0xCA, 0x83, 0x8B, 10, 5, 5, 5, 5, 5, 5, 5, 5, 10}, 12, 4}};
  for (const Row& row : rows) {
    const Areas areas = readIdentifiers(row.bytes);
    EXPECT_EQ(areas.input(), row.input) << int{row.bytes[0]};
    EXPECT_EQ(areas.output(), row.output) << int{row.bytes[0]};
    EXPECT_EQ(areas.wrong, "") << int{row.bytes[0]};
  }
  EXPECT_EQ(readIdentifiers(Bytes{0x43, 0x01, 0x02}).wrong,
            "behind 0x43 there must be 4 bytes, not 2");
}

TEST(GsdIdentifiers, SayWhatIsConsistent) {
  const DataArea area = readIdentifiers(Bytes{0xB3}).areas[0];
  EXPECT_TRUE(area.consistentInput);
  EXPECT_TRUE(area.consistentOutput);
  EXPECT_EQ(area.inputUnit, 1u);
  const DataArea words = readIdentifiers(Bytes{0xC0, 0x41, 0x81}).areas[0];
  EXPECT_EQ(words.outputUnit, 2u);
  EXPECT_FALSE(words.consistentOutput);
  EXPECT_TRUE(words.consistentInput);
}

}  // namespace
}  // namespace merker::gsd
