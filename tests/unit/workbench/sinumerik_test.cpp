// The test functions of a SINUMERIK: what a browser asks of an S7 it may ask of a listing, too.

#include <algorithm>
#include <array>

#include "bench.h"

namespace merker::workbench::test {
namespace {

constexpr const char* kListing =
    "OB 1\n      U     E 0.0\n      SPA   PB 5\n      BE\n"
    "PB 5\n      L     MW 40\n      L     KF +1\n      +F\n      T     MW 40\n      BE\n";

struct Sinumerik5 : ::testing::Test {
  Sinumerik5() {
    folder.write("main.s5", kListing);
    workbench.show(std::make_unique<Plc>(
        compilation::build(project::load(folder.path("main.s5"), {}), false)));
  }
  Json ask(Json request) {
    request["id"] = ++id;
    const Json answer = Json::parse(workbench.handle(1, request.dump()));
    EXPECT_TRUE(answer.contains("result")) << request << answer;
    return answer.value("result", Json());
  }
  // The code of the first problem; empty if it was not refused.
  std::string refusal(Json request) {
    request["id"] = ++id;
    const Json answer = Json::parse(workbench.handle(1, request.dump()));
    return answer.contains("problems") ? answer["problems"][0]["code"].get<std::string>() : "";
  }
  controller::Controller& plc() { return workbench.plc()->controller(); }
  void run(Duration time) { plc().advanceTo(plc().now() + time); }
  Json event(const std::string& name) {
    workbench.beginFrame(++frame);
    for (const std::string& text : workbench.events(1))
      if (Json one = Json::parse(text); one["event"] == name) return one;
    return nullptr;
  }

  Folder folder;
  Workbench workbench;
  std::int64_t id = 0, frame = 0;
};

// S7-STATE-07 for a listing.
TEST_F(Sinumerik5, HoldsAtABreakpointAndSteps) {
  EXPECT_EQ(ask({{"do", "breakpoints.set"}, {"file", "main.s5"}, {"lines", {8}}})["lines"],
            Json({8}));
  run(Duration::milliseconds(200));
  EXPECT_EQ(plc().mode(), controller::Mode::Halt);
  const Json state = event("state");
  EXPECT_EQ(state["mode"], "HALT");
  EXPECT_EQ(state["breakpoint"]["file"], "main.s5");
  EXPECT_EQ(state["breakpoint"]["line"], 8);
  EXPECT_EQ(state["breakpoint"]["block"], "PB 5");
  ask({{"do", "debug.step"}, {"kind", "over"}});
  EXPECT_EQ(event("state")["breakpoint"]["line"], 9);
  ask({{"do", "breakpoints.set"}, {"file", "main.s5"}, {"lines", Json::array()}});
  ask({{"do", "debug.go"}});
  run(Duration::milliseconds(200));
  EXPECT_EQ(plc().mode(), controller::Mode::Run);
  EXPECT_GT(*workbench.plc()->controller().read(workbench.plc()->operand("MW 40").value()), 1u);
}

// Offsets of STEP 5 count words.
TEST_F(Sinumerik5, ShowsMachineCodeBesideItsSource) {
  const Json code = ask({{"do", "program.machineCode"}, {"block", "PB 5"}});
  EXPECT_EQ(code["unit"], "word");
  EXPECT_EQ(code["file"], "main.s5");
  ASSERT_EQ(code["rows"].size(), 5u);
  EXPECT_EQ(code["rows"][1]["text"], "L     KF +1");
  EXPECT_EQ(code["rows"][1]["line"], 7);
  EXPECT_EQ(code["rows"][2]["offset"], code["rows"][1]["offset"].get<int>() + 2);
  EXPECT_EQ(code["rows"][4]["code"], "6500");  // BE
}

// What is refused at once is refused at a trigger point, too, and the constants are the same.
TEST_F(Sinumerik5, ModifiesAtAPointWhatItWrites) {
  const auto code = [&](const char* method, const char* operand, const char* value) {
    const Json items = {{{"operand", operand}, {"value", value}}};
    const Json request = {
        {"id", ++id}, {"do", method}, {"list", 1}, {"items", items}, {"point", "begin"}};
    const Json answer = Json::parse(workbench.handle(1, request.dump()));
    return answer.contains("problems") ? answer["problems"][0]["code"].get<std::string>() : "";
  };
  for (const auto& [operand, value, expected] :
       {std::array{"nc.R 5", "123456789", "P0988"}, std::array{"T 1", "W#16#FFFF", "P0988"},
        std::array{"MW 112", "70000", "P0955"}, std::array{"MW 112", "KF -2", ""},
        std::array{"MD 112", "70000", ""}, std::array{"T 1", "KT 010.2", ""},
        std::array{"nc.R 5", "12.5", ""}})
    for (const char* method : {"variables.write", "modify.set"})
      EXPECT_EQ(code(method, operand, value), expected) << method << operand << value;
  ask({{"do", "variables.force"}, {"items", {{{"operand", "E 0.0"}, {"value", "0"}}}}});
  EXPECT_EQ(code("modify.set", "E 0.0", "1"), "P1217");
  EXPECT_EQ(code("variables.write", "E 0.0", "1"), "");  // at its terminal, where it waits
}

// S7-EDIT-21 for a listing: STEP 5 has no address registers.
TEST_F(Sinumerik5, ShowsProgramStatus) {
  EXPECT_EQ(ask({{"do", "status.show"}, {"file", "main.s5"}, {"line", 7}})["block"], "PB 5");
  run(Duration::milliseconds(200));
  const Json status = event("status");
  EXPECT_EQ(status["file"], "main.s5");
  ASSERT_EQ(status["rows"].size(), 5u) << status;
  EXPECT_EQ(status["rows"][1][0], 7);           // line
  EXPECT_EQ(status["rows"][1][4], "00000001");  // AKKU 1 behind L KF +1
  EXPECT_EQ(status["rows"][1][6], "");          // AR 1
}

TEST_F(Sinumerik5, ListsBlocksAndReferences) {
  const Json blocks = ask({{"do", "program.blocks"}})["blocks"];
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0]["id"], "OB 1");
  EXPECT_EQ(blocks[0]["calls"], Json({"PB 5"}));
  EXPECT_EQ(blocks[1]["file"], "main.s5");
  EXPECT_EQ(blocks[0]["line"], 1);  // of its head
  EXPECT_EQ(blocks[1]["line"], 5);
  const Json rows = ask({{"do", "program.references"}, {"operand", "MW 40"}})["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["access"], "R");
  EXPECT_EQ(rows[1]["line"], 9);
  const std::string text =
      ask({{"do", "program.listing"}, {"block", "PB 5"}})["text"].get<std::string>();
  EXPECT_NE(text.find("+F"), std::string::npos) << text;
}

// FB 61 is a block of the basic program.
TEST_F(Sinumerik5, ListsFunctionBlocksOfTheBasicProgramAsCalled) {
  folder.write(
      "main.s5",
      "OB 1\n      SPA   FB 61\nNAME  : NCD-LESE\nLESE  : M 134.0\nNSBY  : DL 0\nANZ   : KF +0\n"
      "DTY1  : KC TO\nDTY2  : KC S\nDTY3  : KC\nWER1  : KF +0\nWER2  : KF +0\nWER3  : KF +0\n"
      "ZFPN  : KC 00\nZIEL  : KY 0,0\n      SPA   PB 9\n      BE\n");
  workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(folder.path("main.s5"), {}), false)));
  EXPECT_EQ(ask({{"do", "program.blocks"}})["blocks"][0]["calls"], Json({"FB 61", "PB 9"}));
}

// S7-EDIT-22 for a listing: STEP 5 has no local data; FB 61 is a macro, DB 1 a block of the system.
TEST_F(Sinumerik5, HasAProgramStructure) {
  folder.write("main.s5",
               "OB 1\n      A     DB 1\n      L     DW 0\n      A     DB 20\n      SPA   PB 9\n"
               "      BE\n");
  workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(folder.path("main.s5"), {}), false)));
  EXPECT_EQ(ask({{"do", "program.structure"}})["blocks"],
            Json::parse(R"([{"id":"OB 1","uses":[{"id":"DB 1","from":"cpu"},
      {"id":"DB 20","from":"missing"},{"id":"PB 9","from":"missing"}]}])"));
}

// STOP and RUN are keys of the programmer; there is no switch that could stand at MRES.
TEST_F(Sinumerik5, HasKeysForRunAndStopOnly) {
  EXPECT_EQ(refusal({{"do", "cpu.switch"}, {"position", "MRES"}}), "P1307");
  EXPECT_EQ(refusal({{"do", "cpu.switch"}, {"position", "RUN-P"}}), "P1307");
  EXPECT_EQ(refusal({{"do", "cpu.setClock"}, {"time", "2024-01-01 00:00:00"}}), "P1307");
  EXPECT_EQ(plc().mode(), controller::Mode::Run);
  ask({{"do", "cpu.switch"}, {"position", "STOP"}});
  EXPECT_EQ(plc().mode(), controller::Mode::Stop);
  ask({{"do", "cpu.power"}, {"on", false}});
  for (const char* position : {"RUN-P", "RUN", "STOP", "MRES"}) {
    EXPECT_NE(refusal({{"do", "cpu.switch"}, {"position", position}}), "") << position;
    EXPECT_FALSE(plc().powered()) << position;
  }
}

// In its own notation, which the machine takes as input.
TEST_F(Sinumerik5, NamesOperandsAsStep5Does) {
  folder.write("main.s5",
               "OB 1\n      A     DB 20\n      L     DW 5\n      BE\n"
               "DB 20\n   0 : KH = 0000\n   5 : KH = 0000\n");
  folder.write("mainZ0.SEQ", "\tDB 20\tDATEN\r\n\tDW 0\tANZAHL\r\n");
  workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(folder.path("main.s5"), {}), false)));
  const char* const kWords[][2] = {{"-DATEN.DW 5", "DB20.DW 5"},
                                   {"DB20.D 0.12", "DB20.D 0.12"},
                                   {"DB 20.DR0", "DB20.DR 0"},
                                   {"DB20.DL 5", "DB20.DL 5"},
                                   {"DB20.DD 0", "DB20.DD 0"},
                                   {"PY 4", "PY 4"},
                                   {"mw 10", "MW 10"},
                                   {"e0.1", "E 0.1"},
                                   {"T 5", "T 5"},
                                   {"DB20.DW 0", "DB20.DW 0"}};
  Json items = Json::array();
  for (const auto& [written, named] : kWords) items.push_back({{"operand", written}});
  const Json watched = ask({{"do", "watch.set"}, {"list", 1}, {"items", items}})["items"];
  const Json curves = ask({{"do", "trend.set"}, {"list", 1}, {"items", items}})["items"];
  for (std::size_t i = 0; i < std::size(kWords); ++i) {
    EXPECT_EQ(watched[i]["operand"], kWords[i][1]);
    EXPECT_EQ(curves[i]["operand"], kWords[i][1]);
    EXPECT_TRUE(workbench.plc()->operand(watched[i]["operand"].get<std::string>()));
  }
  EXPECT_EQ(watched.back()["symbol"], "ANZAHL");
}

// Also before anything was compiled on the disk.
TEST_F(Sinumerik5, ChecksSymbolsByTheRulesOfStep5AtOnce) {
  const Json rows = {{{"symbol", "WORT"}, {"operand", "DW 5"}},
                     {{"symbol", "FOLGE"}, {"operand", "PB 5"}}};
  EXPECT_EQ(ask({{"do", "symbols.check"}, {"rows", rows}})["problems"], Json::array());
}

// A control has no lamps for it; here it looks like an S7.
TEST_F(Sinumerik5, ShowsHaltInItsLamps) {
  ask({{"do", "breakpoints.set"}, {"file", "main.s5"}, {"lines", {8}}});
  run(Duration::milliseconds(200));
  const Json leds = event("state")["leds"];
  EXPECT_EQ(leds["RUN"], "slow");
  EXPECT_EQ(leds["STOP"], "on");
}

// The assignment list of the program: operands and blocks have names, an editor changes them.
TEST_F(Sinumerik5, HasTheSymbolsOfItsAssignmentList) {
  folder.write("main.s5",
               "OB 1\n! Start der Anlage\n U -TASTER\n = A 1.0\n SPA -FOLGE\n BE\nPB 5\n BE\n");
  folder.write("mainZ0.SEQ", "\tE 1.0\tTASTER\tEin\r\n\tPB 5\tFOLGE\r\n\tPY 4\tWAAGE\r\n");
  workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(folder.path("main.s5"), {}), false)));
  const Json blocks = ask({{"do", "program.blocks"}})["blocks"];
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0]["title"], "Start der Anlage");
  EXPECT_EQ(blocks[1]["symbol"], "FOLGE");
  const Json rows = ask({{"do", "program.references"}})["rows"];
  EXPECT_EQ(rows[0]["symbol"], "TASTER");
  const Json table = ask({{"do", "symbols.read"}});
  EXPECT_EQ(table["path"], "mainZ0.SEQ");
  ASSERT_EQ(table["rows"].size(), 3u);
  EXPECT_EQ(table["rows"][1]["operand"], "PB 5");
  EXPECT_EQ(table["rows"][2]["operand"], "PY 4");
  const Json wrong = {{{"symbol", "X"}, {"operand", "FC 5"}},
                      {{"symbol", "Y"}, {"operand", "SB 5"}}};
  const Json problems = ask({{"do", "symbols.check"}, {"rows", wrong}})["problems"];
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0]["code"], "P1104");
}

TEST_F(Sinumerik5, ShowsStacksAndInformation) {
  ask({{"do", "breakpoints.set"}, {"file", "main.s5"}, {"lines", {8}}});
  run(Duration::milliseconds(200));
  const Json stacks = ask({{"do", "diagnosis.stacks"}});
  ASSERT_EQ(stacks["blocks"].size(), 2u);
  EXPECT_EQ(stacks["blocks"][0]["block"], "PB 5");
  EXPECT_FALSE(stacks["interrupts"][0]["registers"].contains("AR1"));
  EXPECT_EQ(ask({{"do", "diagnosis.information"}})["mode"], "HALT");
  const Json can = event("state")["project"]["can"];
  EXPECT_NE(std::ranges::find(can, "breakpoints"), can.end());
  EXPECT_EQ(std::ranges::find(can, "rack"), can.end());
}

}  // namespace
}  // namespace merker::workbench::test
