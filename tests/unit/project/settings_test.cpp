#include "project/settings.h"

#include <gtest/gtest.h>

namespace merker::project {
namespace {

struct SettingsRead {
  Settings settings;
  Problems problems;
  // "2:1 P0703" of the only problem.
  std::string problem() const {
    if (problems.size() != 1) return std::to_string(problems.size()) + " problems";
    const Problem& p = problems.list()[0];
    return std::to_string(p.position.line) + ":" + std::to_string(p.position.column) + " " +
           std::string(p.name());
  }
};

SettingsRead readText(std::string text) {
  SettingsRead result;
  result.settings =
      readSettings(source::SourceFile("merker.toml", std::move(text)), result.problems);
  return result;
}

TEST(Settings, AllKeysAreOptional) {
  const SettingsRead r = readText("");
  EXPECT_TRUE(r.problems.empty());
  EXPECT_EQ(r.settings.model, &defaultCpuModel());
  EXPECT_FALSE(r.settings.sources.has_value());
  EXPECT_EQ(r.settings.startOfClock,
            1461LL * 24 * 3600 * 1000);  // 1994-01-01: four years, one of them a leap year
}

// S7-MGR-01, S7-NET-03: a new CPU has 2; 0 and 1 belong to others.
TEST(Settings, TheMpiAddress) {
  EXPECT_EQ(readText("").settings.mpiAddress, 2u);
  EXPECT_EQ(readText("[cpu]\nmpi_address = 126").settings.mpiAddress, 126u);
  EXPECT_EQ(readText("[cpu]\nmpi_address = 1").problem(), "2:15 P0704");
  EXPECT_EQ(readText("[cpu]\nmpi_address = 127").problem(), "2:15 P0704");
}

TEST(Settings, EveryKey) {
  const SettingsRead r = readText(R"([project]
name = "Plant"
[program]
sources = ["main.awl", "lib/**/*.awl"]
symbols = []
[cpu]
model = "generic"
clock = "DT#1990-01-02-00:00:01.500"
)");
  EXPECT_TRUE(r.problems.empty());
  EXPECT_EQ(r.settings.name, "Plant");
  ASSERT_EQ(r.settings.sources->size(), 2u);
  EXPECT_EQ((*r.settings.sources)[1].text, "lib/**/*.awl");
  EXPECT_EQ((*r.settings.sources)[1].position.line, 4u);
  EXPECT_TRUE(r.settings.symbols->empty());
  EXPECT_EQ(r.settings.model, findCpuModel("generic"));
  EXPECT_EQ(r.settings.startOfClock, 86'400'000 + 1'500);
}

// S7-LIM-05, S7-LIM-01
TEST(Settings, CommunicationHasTheConnectionsOfTheModel) {
  EXPECT_EQ(readText("").settings.communication.connections, 12u);
  EXPECT_EQ(readText("[cpu]\nmodel = \"312C\"").settings.communication.connections, 6u);
  EXPECT_EQ(readText("[cpu]\nmodel = \"SINUMERIK 810 GA3\"").settings.communication.connections,
            12u);
  const auto own = readText(
      "[communication]\nconnections = 8\npg = 2\nop = 3\nbasic = 3\npdu = 480\n"
      "strict_slot = true\naddress = \"10102\"\n");
  EXPECT_TRUE(own.problems.empty());
  const CommunicationParameters wanted{8, 2, 3, 3, 480, true, "10102"};
  EXPECT_EQ(own.settings.communication, wanted);
  const auto all = readText("[communication]\nconnections = \"unlimited\"\n");
  EXPECT_TRUE(all.problems.empty());
  EXPECT_FALSE(all.settings.communication.connections);
}

TEST(Settings, WrongCommunication) {
  const auto wrong = [](const std::string& line) {
    return readText("[communication]\n" + line + "\n").problem();
  };
  EXPECT_EQ(wrong("conections = 3").substr(0, 9), "2:1 P0703");
  EXPECT_EQ(wrong("connections = 13"), "2:15 P0704");
  EXPECT_EQ(wrong("connections = 0"), "2:15 P0704");
  EXPECT_EQ(wrong("connections = \"all\""), "2:15 P0704");
  EXPECT_EQ(wrong("connections = true"), "2:15 P0704");
  EXPECT_EQ(wrong("pg = 13"), "2:6 P0704");
  EXPECT_EQ(wrong("basic = 9"), "2:9 P0704");
  EXPECT_EQ(wrong("pg = 6\nop = 6\nbasic = 1"), "2:6 P0704");
  EXPECT_EQ(wrong("pg = 0"), "2:6 P0704");  // S7-LIM-05
  EXPECT_EQ(wrong("op = 0"), "2:6 P0704");
  EXPECT_EQ(wrong("connections = 1"), "0 problems");
  EXPECT_EQ(wrong("connections = 1\npg = 0"), "0 problems");
  EXPECT_EQ(wrong("connections = \"unlimited\"\nop = 0"), "0 problems");
  EXPECT_EQ(wrong("pdu = 111"), "2:7 P0704");
  EXPECT_EQ(wrong("pdu = 961"), "2:7 P0704");
  EXPECT_EQ(wrong("strict_slot = 1"), "2:15 P0704");
  for (const char* place :
       {"0.0.0.0:102", "192.168.0.1:102", "102x", "", ":102", "127.0.0.1", "[::]:102"})
    EXPECT_EQ(wrong("address = \"" + std::string(place) + "\""), "2:11 P0704") << place;
  for (const char* place : {"102", "0", "127.0.0.1:102", "localhost:102", "[::1]:102"})
    EXPECT_EQ(wrong("address = \"" + std::string(place) + "\""), "0 problems") << place;
}

TEST(Settings, ProtectionStandsWithTheCpuOrWithItsConnections) {
  const auto here = readText("[communication]\nprotection = 2\npassword = \"secret\"\n");
  EXPECT_TRUE(here.problems.empty());
  EXPECT_EQ(here.settings.parameters.protection, 2);
  EXPECT_EQ(here.settings.parameters.password, "secret");
  EXPECT_EQ(readText("[communication]\nprotection = 2\n").problem().substr(0, 10), "2:14 P0744");
  EXPECT_EQ(readText("[cpu]\npassword = \"a\"\n[communication]\npassword = \"b\"\n").problem(),
            "4:12 P0704");
  EXPECT_EQ(readText("[cpu]\nmodel = \"SINUMERIK 810 GA3\"\n[communication]\nprotection = 1\n")
                .problem()
                .substr(0, 9),
            "4:1 P0703");
}

// S7-NETPRO-08
TEST(Settings, ConfiguredConnections) {
  const auto read1 = readText(
      "[[connection]]\nid = \"W#16#A\"\npartner = \"tcp://127.0.0.1:10102\"\nslot = 3\n"
      "[[connection]]\nid = 2\npartner = \"tcp://192.168.0.9\"\nactive = false\n"
      "local_tsap = \"11.02\"\npartner_tsap = \"1F.63\"\n"
      "[[connection]]\nid = 3\npartner = \"tcp://[::1]:102\"\nrack = 1\n");
  EXPECT_EQ(read1.problem(), "0 problems");
  const std::vector<ConnectionParameters> wanted = {
      {.id = 10, .port = 10102, .partner = {0x10, 3}},
      {.id = 2,
       .host = "192.168.0.9",
       .active = false,
       .local = {0x11, 2},
       .partner = {0x1F, 0x63}},
      {.id = 3, .host = "::1", .partner = {0x10, 34}}};
  EXPECT_EQ(read1.settings.communication.configured, wanted);
}

TEST(Settings, WrongConnections) {
  const auto wrong = [](const std::string& lines) {
    return readText("[[connection]]\n" + lines + "\n").problem();
  };
  const std::string id = "id = 1\n", partner = "partner = \"tcp://127.0.0.1:102\"\n";
  EXPECT_EQ(wrong(partner + "id = \"W#16#0\""), "3:6 P0704");
  EXPECT_EQ(wrong(partner + "id = \"1\""), "3:6 P0704");
  EXPECT_EQ(wrong(partner + "id = 4096"), "3:6 P0704");
  EXPECT_EQ(wrong(partner), "1:1 P0704");
  EXPECT_EQ(wrong(id), "1:1 P0704");
  for (const char* place : {"127.0.0.1:102", "tcp://127.0.0.1", "tcp://plc:102", "tcp://1.2.3:102",
                            "tcp://1.2.3.256:1", "tcp://127.0.0.1:0", "tcp://127.0.0.1:65536",
                            "tcp://1.2.3.4.5:1", "tcp://1.2.3.:1", "tcp://"})
    EXPECT_EQ(wrong(id + "partner = \"" + place + "\""), "3:11 P0704") << place;
  EXPECT_EQ(wrong(id + partner + "active = 1"), "4:10 P0704");
  EXPECT_EQ(wrong(id + partner + "slot = 32"), "4:8 P0704");
  EXPECT_EQ(wrong(id + partner + "local_tsap = \"1002\""), "4:14 P0704");
  EXPECT_EQ(wrong(id + partner + "partner_tsap = \"10.0G\""), "4:16 P0704");
  EXPECT_EQ(wrong(id + partner + "port = 3").substr(0, 9), "4:1 P0703");
  EXPECT_EQ(wrong(id + partner + "[[connection]]\n" + id + partner), "5:6 P0704");
  const std::string passive = "active = false\nlocal_tsap = \"10.02\"\n";
  EXPECT_EQ(wrong(id + partner + passive + "[[connection]]\nid = 2\n" + partner + passive),
            "10:14 P0704");
  std::string many = "[communication]\nconnections = 4\n";
  for (int i = 1; i <= 3; ++i) many += "[[connection]]\nid = " + std::to_string(i) + "\n" + partner;
  EXPECT_EQ(readText(many).problem(), "10:6 P0704");
}

TEST(Settings, UnknownKeysHaveTheirPlace) {
  EXPECT_EQ(readText("[projekt]\n").problem().substr(0, 9), "1:2 P0703");
  EXPECT_EQ(readText("[cpu]\n  modell = \"x\"\n").problem(), "2:3 P0703");
  EXPECT_EQ(readText("name = 1\n").problem(), "1:1 P0703");
  EXPECT_NE(readText("[cpu]\nmodell = \"x\"\n").problems.list()[0].message.find("model, clock"),
            std::string::npos);
}

TEST(Settings, WrongValues) {
  EXPECT_EQ(readText("[project]\nname = 5\n").problem(), "2:8 P0704");
  EXPECT_EQ(readText("[program]\nsources = \"a.awl\"\n").problem(), "2:11 P0704");
  EXPECT_EQ(readText("[program]\nsources = [\"a.awl\", 5]\n").problem(), "2:21 P0704");
  EXPECT_EQ(readText("[cpu]\nmodel = \"317\"\n").problem(), "2:9 P0705");
  EXPECT_EQ(readText("project = 1\n").problem(), "1:1 P0704");
  EXPECT_EQ(readText("[cpu]\nclock = 2005-03-01\n").problem(), "2:9 P0704");
  EXPECT_EQ(readText("[cpu]\nclock = \"DT#2005-13-01-00:00:00\"\n").problems.size(), 1u);
}

TEST(Settings, WhatIsNoToml) {
  const SettingsRead r = readText("[cpu]\nmodel = \n");
  ASSERT_EQ(r.problems.size(), 1u);
  EXPECT_EQ(r.problems.list()[0].code, ProblemCode::P0702);
  EXPECT_EQ(r.problems.list()[0].position.line, 2u);
}

}  // namespace
}  // namespace merker::project
