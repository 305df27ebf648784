#include "bench.h"
#include "workbench/base64.h"

namespace merker::workbench::test {
namespace {

Json row(const std::string& symbol, const std::string& operand, const std::string& type,
         const std::string& comment = {}) {
  return {{"symbol", symbol}, {"operand", operand}, {"type", type}, {"comment", comment}};
}

TEST(Symbols, AreReadAndWritten) {
  Bench bench;
  Json read = bench.call("symbols.read");
  EXPECT_EQ(read["path"], "main.sym");
  ASSERT_EQ(read["rows"].size(), 3u);
  EXPECT_EQ(read["rows"][0], row("Start", "E 0.0", "BOOL", "the button"));
  Json rows = read["rows"];
  rows.push_back(row("Störung", "M 1.0", "BOOL", "über"));
  bench.call("symbols.write", {{"rows", rows}, {"revision", read["revision"]}});
  EXPECT_EQ(bench.call("symbols.read")["rows"], rows);
  EXPECT_EQ(bench.problem("symbols.write", {{"rows", rows}, {"revision", read["revision"]}}),
            "P1311");
}

// S7-SYM-03: nothing is saved while a row is wrong; S7-SYM-16 says what is wrong.
TEST(Symbols, AreCheckedRowByRow) {
  Bench bench;
  const Json rows = {row("Motor", "A 0.0", "BOOL"),
                     row("motor", "A 0.1", "BOOL"),
                     row("Far", "MW 9999999", "INT"),
                     row("Level", "MW 2", "BOOL"),
                     row(std::string(25, 'x'), "M 5.0", "BOOL"),
                     row("Long", "M 5.1", "BOOL", std::string(81, 'c'))};
  std::map<std::int64_t, std::string> wrong;
  const Json checked = bench.call("symbols.check", {{"rows", rows}});
  for (const Json& one : checked["problems"]) wrong[one["row"]] = one["field"];
  EXPECT_EQ(wrong[1], "symbol");
  EXPECT_EQ(wrong[2], "operand");
  EXPECT_EQ(wrong[3], "type");
  EXPECT_EQ(wrong[4], "symbol");
  EXPECT_EQ(wrong[5], "comment");
  EXPECT_FALSE(wrong.contains(0));
  const std::string before = bench.folder.read("main.sym");
  const Json revision = bench.call("symbols.read")["revision"];
  const Json answer = bench.ask("symbols.write", {{"rows", rows}, {"revision", revision}});
  EXPECT_EQ(answer["problems"][0]["row"], 1);
  EXPECT_EQ(bench.folder.read("main.sym"), before);
}

// What is wrong is said of the field that it is about.
TEST(Symbols, ARowWithoutItsOperandOrWithAQuotationMarkIsToldAsThat) {
  Bench bench;
  const Json rows = {row("Motor", "A 0.0", "BOOL"), row("Pump", " ", "BOOL"),
                     row("Val\"ve", "A 0.1", "BOOL"), row("Far", "MW 9999999", "INT")};
  const Json problems = bench.call("symbols.check", {{"rows", rows}})["problems"];
  ASSERT_EQ(problems.size(), 3u) << problems;
  EXPECT_EQ(problems[0]["row"], 1);
  EXPECT_EQ(problems[0]["field"], "operand");
  EXPECT_EQ(problems[0]["code"], "P0812");
  EXPECT_EQ(problems[1]["row"], 2);
  EXPECT_EQ(problems[1]["field"], "symbol");
  EXPECT_EQ(problems[1]["code"], "P0809");
  EXPECT_EQ(problems[2]["row"], 3);
}

TEST(Symbols, LineBreaksMakeNoRows) {
  Bench bench;
  const Json checked =
      bench.call("symbols.check",
                 {{"rows", {row("A\n\"B\" M 0.0", "M 0.1", "BOOL"), row("C", "M 0.2", "BOOL")}}});
  for (const Json& one : checked["problems"]) EXPECT_EQ(one["row"], 0);
}

TEST(Symbols, GoOutAndComeBackInTheFormatsOfStep7) {
  Bench bench;
  const Json rows = bench.call("symbols.read")["rows"];
  for (const char* format : {"asc", "sdf", "dif", "seq"}) {
    const Json text = bench.call("symbols.export", {{"format", format}})["text"];
    const Json back = bench.call("symbols.import", {{"format", format}, {"text", text}})["rows"];
    ASSERT_EQ(back.size(), rows.size()) << format;
    EXPECT_EQ(back[2]["symbol"], "Counted");
    EXPECT_EQ(back[2]["operand"], "MW 20");
  }
  EXPECT_EQ(bench.problem("symbols.export", {{"format", "xls"}}), "P1305");
}

// The file is in a page that has the characters; the text always has all.
TEST(Symbols, GoOutInAPageThatHasTheirCharacters) {
  Bench bench;
  const auto exported = [&](const char* name, const char* format) {
    return bench.call("symbols.export",
                      {{"format", format}, {"rows", {row(name, "M 0.1", "BOOL")}}});
  };
  EXPECT_EQ(exported("Motor", "sdf")["codePage"], 1252);
  const Json russian = exported("Мотор", "sdf");
  EXPECT_EQ(russian["codePage"], 1251);
  EXPECT_EQ(russian["missing"], 0);
  EXPECT_NE(russian["text"].get<std::string>().find("Мотор"), std::string::npos);
  const auto bytes = fromBase64(russian["data"].get<std::string>());
  EXPECT_EQ(std::string(bytes->begin() + 1, bytes->begin() + 6), "\xCC\xEE\xF2\xEE\xF0");
  EXPECT_EQ(exported("Мотор Größe", "sdf")["missing"], 2);
  EXPECT_EQ(exported("Мотор Größe", "sym")["codePage"], 65'001);
}

// What is no row is named with its line, not left out in silence.
TEST(Symbols, LinesThatAreNoRowsAreNamed) {
  Bench bench;
  bench.folder.write("main.sym", "\"Start\"  E 0.0  BOOL\nhello\n");
  const Json read = bench.call("symbols.read");
  EXPECT_EQ(read["rows"].size(), 1U);
  ASSERT_EQ(read["problems"].size(), 1U);
  EXPECT_EQ(read["problems"][0]["file"], "main.sym");
  EXPECT_EQ(read["problems"][0]["line"], 2);
}

// A table that is saved in a format of STEP 7 keeps its characters.
TEST(Symbols, AreSavedWithAllCharacters) {
  for (const std::string name : {"Größe", "Мотор"}) {
    Bench bench;
    std::filesystem::remove(bench.folder.path("main.sym"));
    bench.folder.write("main.sdf", "\"Start\",\"E 0.0\",\"BOOL\",\"\"\r\n");
    bench.call("files.list");
    const Json before = bench.call("symbols.read");
    ASSERT_EQ(before["path"], "main.sdf");
    bench.call("symbols.write",
               {{"rows", {row(name.c_str(), "E 0.0", "BOOL")}}, {"revision", before["revision"]}});
    EXPECT_EQ(bench.call("symbols.read")["rows"][0]["symbol"], name);
    EXPECT_EQ(bench.folder.read("main.sdf").find("\xD0") != std::string::npos, name == "Мотор");
  }
}

}  // namespace
}  // namespace merker::workbench::test
