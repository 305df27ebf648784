#include "bench.h"

namespace merker::workbench::test {
namespace {

// MW 100 gets what FC 1 says.
std::string program(int value, const std::string& more = {}) {
  return "FUNCTION FC 1 : VOID\nTITLE = A number\nBEGIN\nNETWORK\n      L     " +
         std::to_string(value) + ";\n      T     MW 100;\nEND_FUNCTION\n" + more +
         "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      CALL  FC 1;\nEND_ORGANIZATION_BLOCK\n";
}

std::int64_t number(Bench& bench, const std::string& operand = "MW 100") {
  return bench.call("variables.read", {{"items", {{{"operand", operand}}}}})["items"][0]["raw"];
}

void save(Bench& bench, const std::string& text) { bench.folder.write("main.awl", text); }

std::map<std::string, std::string> states(Bench& bench) {
  std::map<std::string, std::string> result;
  const Json answer = bench.call("program.compare");
  for (const Json& row : answer["blocks"]) result[row["id"]] = row["state"];
  return result;
}

TEST(Program, IsCheckedWithWhatIsNotSavedYet) {
  Bench bench;
  Json good = bench.call("program.check");
  EXPECT_EQ(good["problems"].size(), 0u);
  EXPECT_EQ(good["blocks"], 2);
  const Json file = {{"path", "main.awl"},
                     {"text",
                      "ORGANIZATION_BLOCK OB 1\nBEGIN\n L MW 300;\n"
                      "END_ORGANIZATION_BLOCK\n"}};
  const Json bad = bench.call("program.check", {{"files", {file}}});
  EXPECT_EQ(bad["problems"][0]["code"], "P0214");
  EXPECT_EQ(bad["problems"][0]["file"], "main.awl");
  EXPECT_EQ(bad["problems"][0]["line"], 3);
  EXPECT_EQ(bench.folder.read("main.awl"), kProgram);
  const Json settings = {{"path", "merker.toml"}, {"text", "[cpu]\nmodle = 1\n"}};
  EXPECT_EQ(bench.call("program.check", {{"files", {settings}}})["problems"][0]["file"],
            "merker.toml");
}

// S7-EDIT-02
TEST(Program, SaysWhereItsVariablesAre) {
  Bench bench;
  const Json file = {{"path", "main.awl"},
                     {"text",
                      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  Ready : BYTE;\n  Count : WORD;\nEND_VAR\n"
                      "BEGIN\nEND_FUNCTION_BLOCK\n"}};
  const Json rows = bench.call("program.check", {{"files", {file}}})["interfaces"];
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["block"], "FB 1");
  EXPECT_EQ(rows[0]["file"], "main.awl");
  EXPECT_EQ(rows[0]["line"], 1);
  EXPECT_EQ(rows[0]["variables"][0], Json({{"name", "Ready"}, {"address", "0.0"}}));
  EXPECT_EQ(rows[0]["variables"][1], Json({{"name", "Count"}, {"address", "2.0"}}));
}

// S7-CYCLE-05, S7-SIM-11
TEST(Program, IsLoadedWhileTheCpuRuns) {
  Bench bench(program(1));
  EXPECT_EQ(number(bench), 1);
  save(bench, program(2));
  bench.call("program.load");
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(number(bench), 2);
  EXPECT_EQ(bench.state()["mode"], "RUN");
  save(bench, program(3));
  bench.call("cpu.switch", {{"position", "RUN"}});
  EXPECT_EQ(bench.problem("program.load"), "P1308");
  bench.call("cpu.switch", {{"position", "STOP"}});
  bench.call("program.load");
  bench.call("cpu.switch", {{"position", "RUN-P"}});
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(number(bench), 3);
}

// S7 communication loads beside the workbench, which shows what the CPU has.
TEST(Program, OthersLoadBlocks) {
  Bench bench(program(1));
  station::BlockCpu& cpu = *bench.workbench.plc()->blockCpu();
  const auto before = bench.state()["program"];
  auto changed = std::make_shared<block::Program>(cpu.program());
  changed->erase({BlockKind::FC, 1});
  changed->at({BlockKind::OB, 1}).code = {0x65, 0x00};  // BE
  EXPECT_EQ(cpu.download(changed, {}), "");
  bench.run(Duration::milliseconds(20));
  EXPECT_NE(bench.state()["program"], before);
  EXPECT_EQ(states(bench),
            (std::map<std::string, std::string>{{"FC 1", "onlyOffline"}, {"OB 1", "different"}}));
  const auto seen = bench.state()["program"];
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(bench.state()["program"], seen);
}

TEST(Program, WithErrorsStaysOutOfTheCpu) {
  Bench bench(program(1));
  save(bench, "FUNCTION FC 1 : VOID\nBEGIN\n L MW 300;\nEND_FUNCTION\n");
  const Json answer = bench.ask("program.load");
  EXPECT_EQ(answer["problems"][0]["file"], "main.awl");
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(number(bench), 1);
}

TEST(Program, IsLoadedBlockByBlock) {
  Bench bench(program(1));
  save(bench, program(2, "FUNCTION FC 2 : VOID\nBEGIN\nEND_FUNCTION\n"));
  EXPECT_EQ(states(bench), (std::map<std::string, std::string>{
                               {"FC 1", "different"}, {"FC 2", "onlyOffline"}, {"OB 1", "same"}}));
  bench.call("program.load", {{"blocks", {"FC 2"}}});
  EXPECT_EQ(states(bench), (std::map<std::string, std::string>{
                               {"FC 1", "different"}, {"FC 2", "same"}, {"OB 1", "same"}}));
  EXPECT_EQ(bench.problem("program.load", {{"blocks", {"FC 9"}}}), "P1206");
  bench.call("program.delete", {{"blocks", {"FC 2"}}});
  EXPECT_EQ(states(bench)["FC 2"], "onlyOffline");
}

TEST(Program, AnotherHardwareIsLoadedInStop) {
  Bench bench(program(1));
  bench.folder.write("merker.toml", "[cpu]\nmodel = \"315-2 DP\"\n");
  bench.folder.write("merker.toml", "[cpu]\nmodel = \"313C\"\n");
  EXPECT_EQ(bench.problem("program.load"), "P1308");
  bench.call("cpu.stop");
  bench.call("program.load");
  EXPECT_EQ(bench.state()["project"]["model"], "CPU 313C");
}

TEST(Program, BlocksAreListed) {
  Bench bench(program(1));
  for (const char* side : {"offline", "online"}) {
    const Json list = bench.call("program.blocks", {{"side", side}})["blocks"];
    ASSERT_EQ(list.size(), 2u);
    const Json& ob = list[0];
    EXPECT_EQ(ob["id"], "OB 1");
    EXPECT_EQ(ob["calls"], Json::array({"FC 1"}));
    EXPECT_EQ(ob["file"], "main.awl");
    EXPECT_EQ(ob["line"], 8);
    EXPECT_EQ(list[1]["title"], "A number");
    EXPECT_GT(list[1]["load"], list[1]["work"]);
  }
}

// S7-EDIT-22: SFC 64 is of the CPU, FC 60 of nobody, and so is FC 99 when it is called without
// parameters: FC 97 of the library is not (P0508).
TEST(Program, StructureSaysWhatIsMissing) {
  Bench bench(
      "DATA_BLOCK DB 1\nSTRUCT\n a : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n AUF DB 1;\n UC FC 60;\n UC FC 99;\n"
      " CALL FC 97 (IN := MW 10, RET_VAL := MD 60);\n CALL SFC 64 (RET_VAL := MD "
      "50);\nEND_ORGANIZATION_BLOCK\n");
  const Json list = bench.call("program.structure")["blocks"];
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0]["id"], "OB 1");
  EXPECT_GE(list[0]["local"], 20);
  EXPECT_EQ(list[0]["uses"], Json::parse(R"([{"id":"DB 1","from":"program"},
      {"id":"FC 60","from":"missing"},{"id":"FC 97","from":"library"},
      {"id":"FC 99","from":"missing"},{"id":"SFC 64","from":"cpu"}])"));
}

TEST(Program, BlocksOfTheCpuBecomeSources) {
  Bench bench(program(1));
  save(bench, program(2));
  const Json files = bench.call("program.upload", {{"blocks", {"FC 1"}}})["files"];
  EXPECT_EQ(files, Json::array({"online/FC1.awl"}));
  EXPECT_NE(bench.folder.read("online/FC1.awl").find("L     1;"), std::string::npos);
  EXPECT_EQ(bench.problem("program.upload", {{"blocks", {"FC 1"}}}), "P1312");
  // The project has FC 1 already: it is not compiled twice.
  EXPECT_EQ(bench.call("program.check")["problems"], Json::array());
  bench.call("program.load");
}

// A UDT exists in the project only.
TEST(Program, ADataTypeIsInNoCpu) {
  Bench bench("TYPE UDT 1\nSTRUCT\n a : INT;\nEND_STRUCT\nEND_TYPE\n" + program(1));
  const auto names = [&bench](const Json& list) {
    std::string all;
    for (const Json& row : list) all += row["id"].get<std::string>() + " ";
    return all;
  };
  EXPECT_EQ(names(bench.call("program.blocks", {{"side", "offline"}})["blocks"]),
            "UDT 1 OB 1 FC 1 ");
  EXPECT_EQ(names(bench.call("program.blocks", {{"side", "online"}})["blocks"]), "OB 1 FC 1 ");
  EXPECT_EQ(names(bench.call("program.compare")["blocks"]), "OB 1 FC 1 ");
  const Json files = bench.call("program.upload")["files"];
  EXPECT_EQ(files, Json::array({"online/OB1.awl", "online/FC1.awl"}));
}

TEST(Program, ABlockThatTheProjectLostComesBackIntoIt) {
  Bench bench(program(1));
  save(bench, "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nEND_ORGANIZATION_BLOCK\n");
  const Json files = bench.call("program.upload", {{"blocks", {"FC 1"}}})["files"];
  EXPECT_EQ(files, Json::array({"FC1.awl"}));
  EXPECT_EQ(bench.call("program.blocks", {{"side", "offline"}})["blocks"].size(), 2u);
}

// S7-EDIT-04, S7-EDIT-05, S7-EDIT-19, S7-EDIT-23: titles and comments of block and networks come
// back from the CPU, and the source that comes back is the same block.
TEST(Program, ABlockBecomesASourceAndTheSameBlock) {
  const std::string block =
      "FUNCTION FC 1 : VOID\nTITLE = A block\n//What it is for\nVERSION : 0.1\nBEGIN\nNETWORK\n"
      "TITLE = First network\n//What happens there\n      L     1;  //a value\n      T     MW "
      "100;\n"
      "NETWORK\nTITLE = Second network\n      L     2;\n      T     MW 102;\nEND_FUNCTION\n";
  const std::string rest =
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      CALL  FC 1;\nEND_ORGANIZATION_BLOCK\n";
  Bench bench(block + rest);
  bench.call("program.upload", {{"blocks", {"FC 1"}}});
  const std::string source = bench.folder.read("online/FC1.awl");
  for (const char* text : {"TITLE = A block", "//What it is for", "TITLE = First network",
                           "//What happens there", "//a value", "TITLE = Second network"})
    EXPECT_NE(source.find(text), std::string::npos) << text;
  save(bench, rest);
  bench.call("files.rename", {{"path", "online/FC1.awl"}, {"to", "FC1.awl"}});
  EXPECT_EQ(states(bench)["FC 1"], "same");
  const Json rows = bench.call("program.references", {{"operand", "MW 102"}})["rows"];
  EXPECT_EQ(rows[0]["network"], 2);
}

TEST(Program, ShowsItsMachineCode) {
  Bench bench(program(7));
  const auto listing = [&](const char* mnemonics) {
    return bench.call("program.listing", {{"block", "FC 1"}, {"mnemonics", mnemonics}})["text"]
        .get<std::string>();
  };
  EXPECT_NE(listing("german").find("L     7"), std::string::npos);
  EXPECT_NE(listing("international").find("T     MW 100"), std::string::npos);
  EXPECT_EQ(bench.problem("program.listing", {{"block", "FC 9"}}), "P1206");
}

// Each instruction beside the line of its source; an offset of STEP 7 counts bytes.
TEST(Program, ShowsMachineCodeBesideItsSource) {
  Bench bench;
  const Json code = bench.call("program.machineCode", {{"block", "ob1"}});
  EXPECT_EQ(code["block"], "OB 1");
  EXPECT_EQ(code["file"], "main.awl");
  EXPECT_EQ(code["unit"], "byte");
  const Json first = {{"offset", 0}, {"code", "C000"}, {"text", "U     E 0.0"},
                      {"line", 11},  {"initial", ""},  {"value", ""}};
  EXPECT_EQ(code["rows"][0], first);
  EXPECT_EQ(code["rows"][2]["offset"], 4);
  EXPECT_EQ(code["rows"][2]["line"], 13);
  EXPECT_EQ(code["rows"][2]["code"].get<std::string>().size(), 9u);  // two words
  EXPECT_EQ(bench.call("program.machineCode",
                       {{"block", "OB 1"}, {"mnemonics", "international"}})["rows"][0]["text"],
            "A     I 0.0");
  const Json data = bench.call("program.machineCode", {{"block", "DB 1"}, {"side", "online"}});
  EXPECT_EQ(data["rows"], Json({{{"offset", 0},
                                 {"code", "0005"},
                                 {"text", "DBW 0  count : INT"},
                                 {"line", 0},
                                 {"initial", "5"},
                                 {"value", "5"}},
                                {{"offset", 2},
                                 {"code", "3FC0 0000"},
                                 {"text", "DBD 2  level : REAL"},
                                 {"line", 0},
                                 {"initial", "1.500000e+000"},
                                 {"value", "1.500000e+000"}}}));
  EXPECT_EQ(bench.problem("program.machineCode", {{"block", "FC 9"}}), "P1206");
  // Blocks of the CPU have none, and are no wrong names either.
  EXPECT_EQ(bench.problem("program.machineCode", {{"block", "SFB 4"}}), "P1308");
}

// The BE that the compiler adds was made of the line that ends the block, one that is written of
// its own.
TEST(Program, TheEndOfABlockHasItsLine) {
  Bench bench(
      "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n  U E 0.0;\n  = A 0.0;\nEND_FUNCTION\n"
      "FUNCTION FC 2 : VOID\nBEGIN\nNETWORK\n  U E 0.0;\n  BE;\nEND_FUNCTION\n");
  const auto last = [&](const char* block) {
    return bench.call("program.machineCode", {{"block", block}})["rows"].back();
  };
  EXPECT_EQ(last("FC 1")["text"], "BE");
  EXPECT_EQ(last("FC 1")["line"], 6);
  const Json rows = bench.call("program.machineCode", {{"block", "FC 2"}})["rows"];
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1]["line"], 11);
  EXPECT_EQ(rows[2]["line"], 12);
}

// Bits, arrays and structures by their names and addresses; what changed keeps what it began with.
TEST(Program, ShowsTheVariablesOfADataBlock) {
  Bench bench(
      "DATA_BLOCK DB 2\nSTRUCT\n  run : BOOL;\n  stop : BOOL := TRUE;\n"
      "  list : ARRAY [1..2] OF INT := 2 (7);\n  part : STRUCT\n   name : STRING [3] := 'ab';\n"
      "  END_STRUCT;\nEND_STRUCT;\nBEGIN\n  list[2] := 8;\nEND_DATA_BLOCK\n");
  std::string text;
  const Json shown = bench.call("program.machineCode", {{"block", "DB 2"}});
  for (const Json& row : shown["rows"])
    text +=
        fmt::format("{} {} | {} | {}\n", row["offset"].get<int>(), row["text"].get<std::string>(),
                    row["initial"].get<std::string>(), row["value"].get<std::string>());
  EXPECT_EQ(text,
            "0 DBX 0.0  run : BOOL | FALSE | FALSE\n"
            "0 DBX 0.1  stop : BOOL | TRUE | TRUE\n"
            "2 DBW 2  list[1] : INT | 7 | 7\n"
            "4 DBW 4  list[2] : INT | 7 | 8\n"
            "6 DBB 6  part.name : STRING [3] | 'ab' | 'ab'\n");
}

// What the CPU has is written as the source would say it, and by its name.
TEST(Program, ShowsTheDataViewOfABlock) {
  Bench bench(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n run : BOOL;\nEND_VAR\nVAR\n list : ARRAY [1..2] OF INT := "
      "7, 8; "
      "// two\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 2 FB 1\nBEGIN\n list[2] := 9;\nEND_DATA_BLOCK\n");
  const Json offline = bench.call("program.data", {{"block", "db2"}});
  EXPECT_EQ(offline["block"], "DB 2");
  EXPECT_EQ(offline["instanceOf"], "FB 1");
  ASSERT_EQ(offline["rows"].size(), 3u);
  const Json run = {{"operand", "DB2.run"}, {"format", "AUTO"},  {"address", "0.0"},
                    {"path", "run"},        {"type", "BOOL"},    {"section", "IN"},
                    {"initial", "FALSE"},   {"actual", "FALSE"}, {"comment", ""}};
  EXPECT_EQ(offline["rows"][0], run);
  EXPECT_EQ(offline["rows"][2]["initial"], "8");
  EXPECT_EQ(offline["rows"][2]["actual"], "9");
  EXPECT_EQ(offline["rows"][2]["section"], "STAT");
  EXPECT_EQ(offline["rows"][2]["comment"], "two");
  EXPECT_EQ(offline["assignments"], "  list[2] := 9;\n");
  const Json write = {{"operand", offline["rows"][1]["operand"]}, {"value", "-4"}};
  bench.call("variables.write", {{"items", {write}}});
  const Json online = bench.call("program.data", {{"block", "DB 2"}, {"side", "online"}});
  EXPECT_EQ(online["rows"][1]["actual"], "-4");
  EXPECT_EQ(online["assignments"], "  list[1] := -4;\n  list[2] := 9;\n");
  EXPECT_EQ(online["without"], Json::array());
  EXPECT_EQ(bench.problem("program.data", {{"block", "FB 1"}}), "P1308");
  EXPECT_EQ(bench.problem("program.data", {{"block", "DB 9"}}), "P1206");
}

// S7-EDIT-22
TEST(Program, ListsWhatIsAssignedAndWhatNothingUses) {
  Bench bench;
  const Json answer = bench.call("program.assignments");
  const Json input = {{"area", "E"},     {"byte", 0},       {"bits", 0x81},
                      {"byByte", false}, {"byWord", false}, {"byDWord", false}};
  EXPECT_EQ(answer["bytes"][0], input);
  EXPECT_EQ(answer["timers"], Json({1}));
  EXPECT_EQ(answer["counters"], Json::array());
  bench.folder.write("main.sym", std::string(kSymbols) + "\"Nobody\" M 99.0\n");
  bool found = false;
  const Json later = bench.call("program.assignments");
  for (const Json& row : later["unused"]) found |= row["symbol"] == "Nobody";
  EXPECT_TRUE(found) << later.dump();
}

TEST(Program, KnowsWhatCanBeCompleted) {
  Bench bench;
  const Json words = bench.call("program.completion");
  EXPECT_EQ(words["symbols"][0]["name"], "Start");
  EXPECT_EQ(words["symbols"][0]["operand"], "E 0.0");
  EXPECT_EQ(words["symbols"][2]["type"], "INT");
  const auto operation = [&](const char* mnemonics, const char* word) {
    for (const Json& row : words["mnemonics"][mnemonics])
      if (row[0] == word) return row[2].get<std::string>();
    return std::string();
  };
  EXPECT_EQ(operation("german", "U"), "AND");
  EXPECT_EQ(operation("international", "U"), "");
  EXPECT_EQ(operation("international", "A"), "AND");
}

TEST(Program, KnowsWhereOperandsAreUsed) {
  Bench bench(program(1));
  const Json rows = bench.call("program.references", {{"operand", "MW 100"}})["rows"];
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["block"], "FC 1");
  EXPECT_EQ(rows[0]["access"], "W");
  EXPECT_EQ(rows[0]["line"], 6);
  EXPECT_GT(bench.call("program.references")["rows"].size(), 1u);
}

TEST(Watch, FollowsItsSymbolsThroughALoad) {
  const auto source = [](const char* first) {
    return std::string("DATA_BLOCK DB 5\nSTRUCT\n") + first +
           " x : INT := 77;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n" + program(1);
  };
  Bench bench(source(""));
  bench.call("watch.set", {{"list", 1}, {"items", {{{"operand", "DB5.x"}}}}});
  EXPECT_EQ(bench.event("values")["values"][0][2], 77);
  save(bench, source(" before : INT := 5;\n"));
  bench.call("program.load");
  bench.run(Duration::milliseconds(20));
  bench.events();
  EXPECT_EQ(number(bench, "DB5.x"), 77);
  EXPECT_EQ(number(bench, "DB5.DBW 0"), 5);
}

}  // namespace
}  // namespace merker::workbench::test
