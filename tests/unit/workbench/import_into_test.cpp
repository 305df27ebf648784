// What is imported into the open project: each file has its line, nothing is replaced, and the
// report speaks of this project.

#include <deque>

#include "transfer.h"
#include "workbench/upload.h"

namespace merker::workbench::test {
namespace {

namespace fs = std::filesystem;

bool says(const Json& result, const std::string& words) {
  return Transfer::told(result, "came", words) || Transfer::told(result, "changed", words) ||
         Transfer::told(result, "lost", words);
}

TEST_F(Transfer, EachFileHasItsLine) {
  const std::string scenario = "0s: E 0.0 = 1\n";
  const Json result = bring({{"motor.awl", kMotorSource},
                             {"names.sym", "\"Pump\" A 7.0 BOOL\n"},
                             {"start.scn", scenario},
                             {"watch.vat", "MW 20\n"},
                             {"panel.hmi", "lamp ; 20 ; 20 ; 40 ; 40 ; A 0.0\n"},
                             {"manual.pdf", std::string("%PDF-1.4\0\xFF", 10)}});
  EXPECT_EQ(result["files"],
            Json({"motor.awl", "names.sym", "panel.hmi", "start.scn", "watch.vat"}));
  EXPECT_EQ(bench.folder.read("start.scn"), scenario);
  for (const char* name : {"motor.awl", "names.sym", "panel.hmi", "start.scn", "watch.vat"})
    EXPECT_TRUE(told(result, "came", std::string(name) + " is copied as it is")) << name;
  EXPECT_TRUE(told(result, "beside", "manual.pdf is not a file that can be imported"));
}

TEST_F(Transfer, TheReportIsAboutTheOpenProject) {
  const Json result = bring({{"a.awl", kMotorSource}, {"b.awl", kMotorSource}});
  EXPECT_FALSE(says(result, "generic")) << result.dump();
  EXPECT_FALSE(says(result, "merker-import")) << result.dump();
  EXPECT_TRUE(told(result, "changed", "`merker check` finds 1 error; the first: b.awl:1: FC 7"))
      << result.dump();
}

TEST_F(Transfer, AFileThatExistsHasOneLine) {
  const Json result = bring({{"MAIN.AWL", kMotorSource}, {"new.awl", kMotorSource}});
  EXPECT_EQ(result["files"], Json({"new.awl"}));
  EXPECT_TRUE(told(result, "lost", "main.awl exists in the project; it was not replaced"));
  EXPECT_FALSE(says(result, "MAIN.awl is copied"));
  EXPECT_FALSE(fs::exists(bench.folder.path("MAIN.awl")));
}

TEST_F(Transfer, TheOpenProjectKeepsItsSettings) {
  const std::string before = bench.folder.read("merker.toml");
  const Json result =
      bring({{"motor.awl", kMotorSource}, {"merker.toml", "[project]\nname = \"Other\"\n"}});
  EXPECT_EQ(result["files"], Json({"motor.awl"}));
  EXPECT_TRUE(told(result, "lost", "merker.toml was not replaced")) << result.dump();
  EXPECT_TRUE(result["lost"]);
  EXPECT_EQ(bench.folder.read("merker.toml"), before);
}

TEST_F(Transfer, ANewNameIsSaid) {
  const Json result = bring(
      {{"one/m.awl", kMotorSource}, {"two/M.awl", "// nothing\n" + std::string(kMotorSource)}});
  EXPECT_EQ(result["files"], Json({"M 2.awl", "m.awl"}));
  EXPECT_TRUE(told(result, "changed", "'M.awl' is named 'M 2.awl' in the project"));
}

TEST(ImportInto, AListOfSourcesGrows) {
  Bench bench(kProgram,
              "# the plant\n[program]\n# in this order\nsources = [\"main.awl\"]  # more later\n"
              "symbols = [\"*.sym\"]\n");
  const std::string before = bench.folder.read("merker.toml");
  bench.call("import.begin");
  for (const char* name : {"motor.awl", "more.sym"})
    bench.call("import.add",
               {{"files",
                 {{{"path", name},
                   {"data", base64(name[4] == 'r' ? kMotorSource : "\"P\" A 7.0 BOOL\n")}}}}});
  const Json result = bench.call("import.run");
  std::string expected = before;
  expected.replace(expected.find("\"main.awl\""), 10, "\"main.awl\", \"motor.awl\"");
  EXPECT_EQ(bench.folder.read("merker.toml"), expected);
  EXPECT_TRUE(Transfer::told(result, "came", "merker.toml lists motor.awl"));
  EXPECT_EQ(bench.call("program.blocks")["blocks"].size(), 3u);
}

// Who follows the folder would compile again and again while files come.
TEST_F(Transfer, WhileFilesComeNobodyLooksAtTheFolder) {
  std::deque<Work> works;
  bench.workbench.importBy([&](Work work) { works.push_back(std::move(work)); });
  const auto look = [&] {
    for (int i = 0; i < 100; ++i) bench.events();  // 3.3 s
    return bench.state()["files"];
  };
  bench.call("import.begin");
  send("motor.awl", kMotorSource);
  const Json before = look();
  const Json request = {{"id", 77}, {"do", "import.run"}};
  ASSERT_EQ(bench.workbench.handle(1, request.dump()), "");
  bench.folder.write("half.awl", kMotorSource);
  EXPECT_EQ(look(), before);
  works.front()->carryOut();
  EXPECT_EQ(bench.workbench.laterAnswers().size(), 1u);
  EXPECT_NE(look(), before);
  const Json now = look();
  bench.folder.write("later.awl", kMotorSource);
  EXPECT_NE(look(), now);
}

TEST_F(Transfer, ProgramsOfOneNameAreToldApart) {
  const std::string zip = zipOf({{"one/plant/merker.toml", "[project]\nname = \"One\"\n"},
                                 {"two/plant/merker.toml", "[project]\nname = \"Two\"\n"}});
  bench.call("import.begin");
  send("both.zip", zip);
  EXPECT_EQ(bench.call("import.look")["programs"], Json({"one/plant", "two/plant"}));
  EXPECT_EQ(bench.problem("import.run", {{"name", "x"}, {"program", "plant"}}), "P1316");
  const Json result = bench.call("import.run", {{"name", "x"}, {"program", "two/plant"}});
  EXPECT_EQ(result["folders"], Json({workspace.path("x")}));
  EXPECT_NE(workspace.read("x/merker.toml").find("Two"), std::string::npos);
}

TEST_F(Transfer, AnImportedProjectCanBeImportedAgain) {
  bring({{"motor.awl", kMotorSource}}, {{"name", "first"}});
  ASSERT_TRUE(fs::exists(workspace.path("first/import-report.txt")));
  std::map<std::string, std::string> again;
  for (const char* name : {"merker.toml", "motor.awl", "import-report.txt"})
    again[name] = workspace.read(std::string("first/") + name);
  const Json result = bring(again, {{"name", "second"}});
  EXPECT_FALSE(result["lost"]) << result.dump();
  EXPECT_NE(workspace.read("second/import-report.txt").find("2 files of a Merker project"),
            std::string::npos);
}

TEST_F(Transfer, TheReasonOfWhatCannotBeReadIsTold) {
  const Folder folder;
  zip_t* zip = zip_open(folder.path("x.zip").c_str(), ZIP_CREATE, nullptr);
  const std::string text = kMotorSource;
  const auto index =
      zip_file_add(zip, "secret.awl", zip_source_buffer(zip, text.data(), text.size(), 0), 0);
  ASSERT_GE(index, 0);
  ASSERT_EQ(zip_file_set_encryption(zip, static_cast<zip_uint64_t>(index), ZIP_EM_AES_256, "key"),
            0);
  ASSERT_EQ(zip_close(zip), 0);
  bench.call("import.begin");
  send("x.zip", folder.read("x.zip"));
  for (const char* method : {"import.look", "import.run"}) {
    const Json answer = bench.ask(method, {{"name", "secret"}});
    EXPECT_NE(answer.dump().find("secret.awl: it is encrypted"), std::string::npos) << answer;
  }
}

TEST_F(Transfer, ACodePageCanBeChosen) {
  const std::string source = "// \xC8\n" + std::string(kMotorSource);
  bring({{"a.awl", source}}, {{"name", "greek"}, {"codePage", "1253"}});
  EXPECT_TRUE(workspace.read("greek/a.awl").starts_with("// Θ\n"));
  bench.call("import.begin");
  EXPECT_EQ(bench.problem("import.run", {{"name", "x"}, {"codePage", "1258"}}), "P1305");
}

// A process that was killed leaves its folder, but not its lock.
TEST_F(Transfer, LeftoversOfOthersGo) {
  const auto used = Upload::make();
  for (const char* name : {"merker-import-abcdef/input", "merker-import-other-thing", "merker-x"})
    fs::create_directories(temporary.path(name));
  fs::create_directory_symlink(workspace.path(), temporary.path("merker-import-ghijkl"));
  fs::create_directory_symlink(workspace.path(), temporary.path("merker-import-abcdef/link"));
  workspace.write("mine.txt", "mine");
  Upload::sweep();
  EXPECT_FALSE(fs::exists(temporary.path("merker-import-abcdef")));
  EXPECT_TRUE(fs::exists(temporary.path("merker-import-other-thing")));
  EXPECT_TRUE(fs::exists(temporary.path("merker-x")));
  EXPECT_EQ(workspace.read("mine.txt"), "mine");
  EXPECT_TRUE(fs::exists(fs::path(used->output()).parent_path()));
}

}  // namespace
}  // namespace merker::workbench::test
