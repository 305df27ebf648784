// Several stations in the workbench (S7-MGR-13, S7-NETPRO-02 to -06): which one is shown, commands
// and faults, new stations and global data.
#include "bench.h"

namespace merker::workbench::test {
namespace {

const char* const kCount =
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L MW 20; + 1; T MW 20; U E 0.0; = A 0.0;\n"
    "END_ORGANIZATION_BLOCK\n";

const char* const kLab = R"toml([project]
name = "Lab"
[[station]]
name = "Press"
folder = "press"
[[station]]
name = "Belt"
folder = "belt"
[[subnet]]
name = "MPI(1)"
kind = "mpi"
nodes = [
  {station = "Press", address = 2}, # the first one
  {station = "Belt", address = 3},
]
[[global_data]]
circle = 1
from = "Press/MW 20"
to = ["Belt/MW 40"]
rate = 8
status = ["Belt/MD 50"]
)toml";

struct Stations : testing::Test {
  Stations() {
    bench.workbench.use({bench.folder.path("projects"), "", ""});
    for (const char* name : {"press", "belt"}) {
      bench.folder.write(std::string("projects/lab/") + name + "/merker.toml",
                         "[cpu]\nmodel = \"314C-2 PtP\"\n");
      bench.folder.write(std::string("projects/lab/") + name + "/main.awl", kCount);
    }
    bench.folder.write("projects/lab/merker.toml", kLab);
    bench.call("projects.open", {{"folder", "lab"}});
  }
  Json network() { return bench.call("stations.list")["network"]; }
  // As a browser sees them; told ten times a second, if there is something new.
  Json now() {
    for (int frame = 0; frame < 5; ++frame)
      if (Json event = bench.event("stations"); !event.is_null()) seen_ = std::move(event);
    return seen_;
  }
  std::string text() const { return bench.folder.read("projects/lab/merker.toml"); }
  Json value(const std::string& operand) {
    return bench.call("variables.read", {{"items", {{{"operand", operand}}}}})["items"][0]["raw"];
  }

  Bench bench;
  Json seen_;
};

TEST_F(Stations, AreListedAsTheyStandInTheProject) {
  const Json all = network();
  EXPECT_EQ(all["name"], "Lab");
  EXPECT_EQ(all["shown"], "Press");
  EXPECT_EQ(all["stations"][1]["folder"], "belt");
  EXPECT_EQ(all["subnets"][0]["nodes"][1], (Json{{"station", "Belt"}, {"address", 3}}));
  EXPECT_EQ(all["circles"][0]["to"], Json({"Belt/MW 40"}));
  EXPECT_EQ(all["problems"], Json::array());
  bench.call("projects.close");
  EXPECT_EQ(bench.call("stations.list")["network"], nullptr);
}

TEST_F(Stations, RunTogetherWhicheverIsShown) {
  bench.run(Duration::milliseconds(100));
  EXPECT_GT(value("MW 20"), 10);
  EXPECT_EQ(value("MW 40"), 0);
  bench.call("stations.show", {{"station", "belt"}});
  EXPECT_EQ(network()["shown"], "Belt");
  EXPECT_GT(value("MW 40"), 10);
  const Json before = value("MW 40");
  bench.run(Duration::milliseconds(100));
  EXPECT_GT(value("MW 40"), before);
}

TEST_F(Stations, ARequestForAnotherOneIsRefused) {
  const Json items = {{{"operand", "MW 20"}}};
  bench.call("variables.read", {{"items", items}, {"station", "press"}});
  EXPECT_EQ(bench.problem("variables.read", {{"items", items}, {"station", "Belt"}}), "P1308");
}

TEST_F(Stations, AreCommandedOneByOne) {
  bench.call("stations.command", {{"station", "Belt"}, {"command", "stop"}});
  bench.call("stations.watch", {{"on", true}});
  bench.run(Duration::milliseconds(200));
  const Json seen = now();
  EXPECT_EQ(seen["stations"][0]["mode"], "RUN");
  EXPECT_EQ(seen["stations"][1]["mode"], "STOP");
  bench.call("stations.command", {{"station", "Belt"}, {"command", "powerOff"}});
  EXPECT_EQ(bench.problem("stations.command", {{"station", "Belt"}, {"command", "run"}}), "P1308");
  bench.call("stations.command", {{"station", "Belt"}, {"command", "powerOn"}});
  bench.call("stations.command", {{"station", "Belt"}, {"command", "run"}});
  bench.run(Duration::milliseconds(200));
  EXPECT_EQ(now()["stations"][1]["mode"], "RUN");
  EXPECT_EQ(bench.problem("stations.command", {{"station", "Mill"}, {"command", "run"}}), "P1316");
}

TEST_F(Stations, ALineThatIsBrokenAndMended) {
  bench.call("stations.watch", {{"on", true}});
  bench.call("stations.show", {{"station", "Belt"}});
  bench.run(Duration::milliseconds(200));
  bench.call("stations.fault", {{"subnet", "MPI(1)"}, {"station", "Press"}, {"fault", "break"}});
  bench.run(Duration::milliseconds(200));
  const Json before = value("MW 40");
  bench.run(Duration::milliseconds(200));
  EXPECT_EQ(value("MW 40"), before);
  EXPECT_EQ(now()["subnets"][0]["pulled"], Json({"Press"}));
  bench.call("stations.fault", {{"subnet", "MPI(1)"}, {"fault", "mend"}});
  bench.run(Duration::milliseconds(200));
  EXPECT_GT(value("MW 40"), before);
  const auto status = now()["circles"][0][0].get<std::uint32_t>();
  EXPECT_EQ(status & 0x80000008u, 0x80000008u);
}

TEST_F(Stations, ANewOneIsAddedAndConnected) {
  bench.call("stations.add",
             {{"name", "Mill"}, {"model", "312C"}, {"subnet", "MPI(1)"}, {"address", 4}});
  EXPECT_NE(text().find("# the first one"), std::string::npos);
  EXPECT_EQ(network()["shown"], "Mill");
  EXPECT_EQ(network()["subnets"][0]["nodes"][2], (Json{{"station", "Mill"}, {"address", 4}}));
  bench.call("stations.connect", {{"from", "Press/MW 20"}, {"to", {"Mill/MW 60"}}, {"rate", 4}});
  EXPECT_EQ(network()["circles"][1]["circle"], 2);
  bench.run(Duration::milliseconds(200));
  EXPECT_GT(value("MW 60"), 10);
}

// S7-NETPRO-08
TEST_F(Stations, AConnectionIsAddedWithFreeIds) {
  const std::string before = text();
  const Json wanted = {{"local", "Press"}, {"partner", "Belt"}};
  EXPECT_EQ(bench.problem("stations.link", wanted), "P0704");  // no blocks in a 314C-2
  EXPECT_EQ(bench.problem("stations.link", {{"local", "Press"}, {"partner", "Foo"}}), "P0704");
  EXPECT_EQ(text(), before);
  for (const char* name : {"press", "belt"})
    bench.folder.write(std::string("projects/lab/") + name + "/merker.toml",
                       "[cpu]\nmodel = \"generic\"\n");
  bench.call("stations.link", wanted);
  bench.call("stations.link", {{"local", "Press"}, {"partner", "Belt"}, {"both", true}});
  EXPECT_NE(text().find("# the first one"), std::string::npos);
  const Json rows = network()["connections"];
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1], (Json{{"station", "Press"},
                           {"kind", "s7"},
                           {"id", 2},
                           {"active", true},
                           {"partner", "Belt (MPI(1))"}}));
  EXPECT_EQ(rows[2], (Json{{"station", "Belt"},
                           {"kind", "s7"},
                           {"id", 1},
                           {"active", false},
                           {"partner", "Press (MPI(1))"}}));
  bench.call("stations.show", {{"station", "Belt"}});
  EXPECT_EQ(bench.call("diagnosis.connections")["configured"],
            Json::array({Json{{"kind", "s7"},
                              {"id", 1},
                              {"partner", "Press (MPI(1))"},
                              {"active", false},
                              {"state", "inside"}}}));
}

// S7-NETPRO-03, S7-NETPRO-04
TEST_F(Stations, OneIsConnectedElsewhere) {
  bench.call("stations.subnet", {{"subnet", "MPI(2)"}, {"kind", "mpi"}, {"highest", 15}});
  const auto move = [](const char* station) {
    return Json{{"subnet", "MPI(2)"}, {"station", station}, {"address", "9"}};
  };
  EXPECT_EQ(bench.problem("stations.node", move("Belt")), "P0704");  // it has global data
  bench.call("stations.add",
             {{"name", "Mill"}, {"model", "312C"}, {"subnet", "MPI(1)"}, {"address", 4}});
  bench.call("stations.node", move("Mill"));
  const Json subnets = network()["subnets"];
  EXPECT_EQ(subnets[0]["nodes"].size(), 2u);
  EXPECT_EQ(subnets[1]["highest"], 15);
  EXPECT_EQ(subnets[1]["nodes"], Json::array({Json{{"station", "Mill"}, {"address", 9}}}));
  EXPECT_NE(text().find("# the first one"), std::string::npos);
}

// S7-NETPRO-03, S7-NET-10
TEST_F(Stations, AProfibusSubnetHasItsMasterAndASlave) {
  const Json line{{"subnet", "PROFIBUS(1)"}, {"kind", "profibus"}, {"master", "Mill"}};
  EXPECT_EQ(bench.problem("stations.subnet", line), "P0704");  // no such station
  bench.call("stations.add", {{"name", "Mill"}, {"model", "314C-2 DP"}});
  const std::string added = text();
  EXPECT_EQ(bench.problem("stations.subnet",
                          {{"subnet", "PROFIBUS(1)"}, {"kind", "profibus"}, {"master", "Belt"}}),
            "P0735");  // no DP interface
  EXPECT_EQ(text(), added);
  bench.call("stations.subnet", line);
  const Json made = network()["subnets"][1];
  EXPECT_EQ(made["nodes"], Json::array({Json{{"station", "Mill"}, {"address", 2}}}));
  EXPECT_EQ(made["slaves"][0]["model"], "ET 200M");
  bench.call("stations.subnet", {{"subnet", "PROFIBUS(1)"}, {"remove", true}});
  EXPECT_EQ(network()["subnets"].size(), 1u);
  EXPECT_EQ(text().find("[[slave]]"), std::string::npos);
}

TEST_F(Stations, WhatIsWrongWithASubnetChangesNothing) {
  const std::string before = text();
  const auto node = [&](const char* subnet, const char* station, const char* address) {
    return bench.problem("stations.node",
                         {{"subnet", subnet}, {"station", station}, {"address", address}});
  };
  EXPECT_EQ(node("MPI(1)", "Belt", "2"), "P0704");   // S7-NETPRO-01
  EXPECT_EQ(node("MPI(1)", "Belt", "32"), "P0704");  // above the highest
  EXPECT_EQ(node("MPI(1)", "Belt", "x\"}]"), "P1305");
  EXPECT_EQ(node("MPI(2)", "Belt", "4"), "P1316");
  EXPECT_EQ(node("MPI(1)", "Mill", "4"), "P1316");
  EXPECT_EQ(bench.problem("stations.subnet", {{"subnet", "MPI(1)"}, {"baud", "3M"}}), "P0704");
  EXPECT_EQ(text(), before);
}

TEST_F(Stations, WhatIsWrongWithANewOneChangesNothing) {
  const std::string before = text();
  const auto add = [&](const char* name, int address) {
    return bench.problem("stations.add",
                         {{"name", name}, {"subnet", "MPI(1)"}, {"address", address}});
  };
  EXPECT_EQ(add("Mill", 3), "P0704");
  EXPECT_EQ(add("Belt", 5), "P0742");
  EXPECT_EQ(add("../Mill", 5), "P1305");
  EXPECT_EQ(bench.problem("stations.connect", {{"from", "Press/MW 20"}, {"to", {"Foo/MW 60"}}}),
            "P0704");
  EXPECT_EQ(text(), before);
  EXPECT_FALSE(std::filesystem::exists(bench.folder.path("projects/lab/mill")));
}

TEST_F(Stations, OneStationBecomesTheFirstOfSeveral) {
  bench.call("projects.open", {{"folder", "lab/press"}});
  bench.call("stations.make", {{"name", "Hall"}, {"station", "Saw"}});
  EXPECT_EQ(network()["stations"][0],
            (Json{{"name", "Saw"}, {"folder", "saw"}, {"model", "CPU 314C-2 PtP"}}));
  EXPECT_EQ(bench.folder.read("projects/Hall/saw/main.awl"), kCount);
  bench.run(Duration::milliseconds(100));
  EXPECT_GT(value("MW 20"), 10);
}

TEST_F(Stations, AProjectWithErrorsIsOpenedToo) {
  bench.folder.write("projects/lab/belt/main.awl", "nonsense");
  bench.call("stations.reload");
  EXPECT_FALSE(network()["problems"].empty());
  bench.run(Duration::milliseconds(100));
  EXPECT_GT(value("MW 20"), 10);
}

}  // namespace
}  // namespace merker::workbench::test
