// Import and download: what a browser sends becomes a project or files of one, and nothing else
// is left behind.

#include "transfer.h"

#include <deque>

#include "archive/tree.h"
#include "workbench/upload.h"

namespace merker::workbench::test {
namespace {

namespace fs = std::filesystem;

TEST(Base64, IsThatOfTheStandard) {  // RFC 4648, 10
  const std::pair<const char*, const char*> rows[] = {{"", ""},
                                                      {"f", "Zg=="},
                                                      {"fo", "Zm8="},
                                                      {"foo", "Zm9v"},
                                                      {"foob", "Zm9vYg=="},
                                                      {"fooba", "Zm9vYmE="},
                                                      {"foobar", "Zm9vYmFy"}};
  for (const auto& [text, coded] : rows) {
    EXPECT_EQ(base64(text), coded);
    EXPECT_EQ(bytesOf(coded), text);
  }
  for (const char* wrong : {"Z", "Zg=", "Zg==Zg==", "Z===", "====", "Zm9.", "Zm 9"})
    EXPECT_FALSE(fromBase64(wrong)) << wrong;
}

TEST_F(Transfer, AProjectIsDownloadedAsAZip) {
  bench.folder.write("lib/pump.awl", "// a pump\n");
  bench.folder.write("tests/one.test", std::string("\0\x1b", 2));
  bench.folder.write("card.sqlite-wal", "of this computer");
  bench.folder.write(".merker-saving-main.awl", "half a file");
  fs::create_symlink("/etc/passwd", bench.folder.path("link.awl"));
  const std::string zip = download();
  const archive::Tree tree(archive::fileOf({zip.begin(), zip.end()}));
  std::map<std::string, std::string> files;
  for (const auto& entry : tree.files()) files[entry.path] = tree.open(entry)->text(1 << 20);
  const std::map<std::string, std::string> expected = {
      {"lib/pump.awl", "// a pump\n"},
      {"main.awl", kProgram},
      {"main.sym", kSymbols},
      {"merker.toml", bench.folder.read("merker.toml")},
      {"tests/one.test", std::string("\0\x1b", 2)}};
  EXPECT_EQ(files, expected);
  EXPECT_EQ(bench.call("download.begin")["left"], Json({"card.sqlite-wal", "link.awl"}));
  bench.call("download.end");
  EXPECT_EQ(bench.problem("download.piece", {{"at", 0}}), "P1308");
}

TEST_F(Transfer, ADownloadedProjectComesBack) {
  bench.folder.write("lib/pump.awl", "// a pump\n");
  const std::string zip = download();
  bench.call("import.begin");
  send("plant.zip", zip.substr(0, 100));
  send("plant.zip", zip.substr(100));
  const Json found = bench.call("import.look");
  EXPECT_EQ(found["programs"], Json({"plant"}));
  EXPECT_EQ(found["name"], "plant");
  EXPECT_EQ(found["loose"], false);
  const Json result = bench.call("import.run", {{"name", "plant"}});
  EXPECT_EQ(result["folders"], Json({workspace.path("plant")}));
  EXPECT_EQ(workspace.read("plant/main.awl"), kProgram);
  EXPECT_EQ(workspace.read("plant/lib/pump.awl"), "// a pump\n");
  EXPECT_TRUE(told(result, "came", "4 files of a Merker project"));
  EXPECT_TRUE(nothingLeft());
  bench.call("projects.open", {{"folder", workspace.path("plant")}});
  EXPECT_EQ(bench.state()["project"]["name"], "Test");
}

TEST_F(Transfer, SingleFilesGoIntoTheOpenProject) {
  bench.call("import.begin");
  send("motor.awl", kMotorSource);
  send("main.awl", kMotorSource);
  const Json found = bench.call("import.look");
  EXPECT_EQ(found["programs"], Json::array());
  EXPECT_EQ(found["loose"], true);
  const Json result = bench.call("import.run");
  EXPECT_EQ(result["files"], Json({"motor.awl"}));
  EXPECT_EQ(bench.folder.read("motor.awl"), kMotorSource);
  EXPECT_EQ(bench.folder.read("main.awl"), kProgram);
  EXPECT_EQ(result["lost"], true);
  EXPECT_TRUE(told(result, "lost", "main.awl exists in the project"));
  EXPECT_FALSE(fs::exists(bench.folder.path("import-report.txt")));
  EXPECT_EQ(bench.call("files.list")["files"].size(), 4u);
  EXPECT_TRUE(nothingLeft());
}

TEST_F(Transfer, ANewProjectTakesNoNameThatIsTaken) {
  workspace.write("motor/mine.txt", "mine");
  bench.call("import.begin");
  send("motor.awl", kMotorSource);
  EXPECT_EQ(bench.call("import.look")["name"], "motor 2");
  EXPECT_EQ(bench.problem("import.run", {{"name", "motor"}}), "P1312");
  EXPECT_EQ(bench.problem("import.run", {{"name", "../motor"}}), "P1317");
  EXPECT_EQ(workspace.read("motor/mine.txt"), "mine");
  bench.call("import.run", {{"name", "motor 2"}});
  EXPECT_EQ(workspace.read("motor 2/motor.awl"), kMotorSource);
}

TEST_F(Transfer, WhatNobodyKnowsIsRefusedAndLeavesNothing) {
  bench.call("import.begin");
  send("letter.txt", "Dear reader");
  EXPECT_EQ(bench.problem("import.look"), "P1308");
  EXPECT_EQ(bench.problem("import.run", {{"name", "letter"}}), "P1308");
  EXPECT_FALSE(fs::exists(workspace.path("letter")));
  bench.call("import.cancel");
  EXPECT_TRUE(nothingLeft());
}

// A zip made to leave its folder: what leads out is named, and stays where it is.
TEST_F(Transfer, NothingLeavesTheNewFolder) {
  const std::string zip = zipOf({{"merker.toml", "[project]\nname = \"Evil\"\n"},
                                 {"../evil.awl", kMotorSource},
                                 {"a/../../evil.awl", kMotorSource},
                                 {"/tmp/merker-evil.awl", kMotorSource},
                                 {"good.awl", kMotorSource}});
  bench.call("import.begin");
  send("evil.zip", zip);
  const Json result = bench.call("import.run", {{"name", "evil"}});
  EXPECT_TRUE(told(result, "lost", "leads out of the archive"));
  EXPECT_EQ(workspace.read("evil/good.awl"), kMotorSource);
  EXPECT_FALSE(fs::exists(workspace.path("evil.awl")));
  EXPECT_FALSE(fs::exists("/tmp/merker-evil.awl"));
  EXPECT_TRUE(nothingLeft());
}

TEST_F(Transfer, PathsOfFilesStayInTheirFolder) {
  bench.call("import.begin");
  for (const char* path : {"../x", "/x", "a/../../x", "", ".hidden", "a//b", "c:\\x"}) {
    const Json parts = {{{"path", path}, {"data", ""}}};
    EXPECT_EQ(bench.problem("import.add", {{"files", parts}}), "P1309") << path;
  }
  send("a", "file");
  EXPECT_EQ(bench.problem("import.add", {{"files", {{{"path", "a/b"}, {"data", ""}}}}}), "P1313");
  EXPECT_EQ(bench.problem("import.add", {{"files", {{{"path", "b"}, {"data", "!"}}}}}), "P1305");
}

TEST(Upload, HasALimit) {
  const auto upload = Upload::make();
  const std::vector<std::uint8_t> piece(64u << 20);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(upload->add("large", piece));
  const auto problem = upload->add("one more byte", std::span(piece).first(1));
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->code, ProblemCode::P1314);
}

TEST_F(Transfer, ABrowserThatHasGoneLeavesNothing) {
  bench.workbench.opened(2);
  bench.call("import.begin", {}, 2);
  send("half.zip", "PK\3\4", 2);
  EXPECT_FALSE(nothingLeft());
  EXPECT_EQ(bench.problem("import.begin"), "P1308");  // one at a time
  bench.workbench.closed(2);
  EXPECT_TRUE(nothingLeft());
  bench.call("import.begin");
}

// The import is done elsewhere: the PLC goes on, the same browser may ask for other things and may
// cancel it; nothing of it is left then.
TEST_F(Transfer, ThePlcGoesOnAndTheImportCanBeCancelled) {
  std::deque<Work> works;
  bench.workbench.importBy([&](Work work) { works.push_back(std::move(work)); });
  bench.call("import.begin");
  send("motor.awl", kMotorSource);
  const auto ask = [&](const char* method, Json fields) {
    fields["id"] = 77;
    fields["do"] = method;
    return bench.workbench.handle(1, fields.dump());
  };
  EXPECT_EQ(ask("import.run", {{"name", "motor"}}), "");
  ASSERT_EQ(works.size(), 1u);
  EXPECT_FALSE(bench.workbench.busy(1));
  const std::uint32_t before =
      *bench.workbench.plc()->controller().read(bench.workbench.plc()->operand("MW 20").value());
  bench.run(Duration::milliseconds(50));
  EXPECT_GT(
      *bench.workbench.plc()->controller().read(bench.workbench.plc()->operand("MW 20").value()),
      before);
  EXPECT_EQ(bench.problem("import.add", {{"files", Json::array()}}), "P1308");  // it is running
  bench.call("import.cancel");
  works.front()->carryOut();
  works.clear();
  const auto answers = bench.workbench.laterAnswers();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_NE(answers[0].second.find("P1308"), std::string::npos);
  EXPECT_FALSE(fs::exists(workspace.path("motor")));
  EXPECT_TRUE(nothingLeft());
}

}  // namespace
}  // namespace merker::workbench::test
