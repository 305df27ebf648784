#include "project/files.h"

#include <filesystem>

#include "bench.h"

namespace merker::workbench::test {
namespace {

namespace fs = std::filesystem;

TEST(Files, AreListedReadAndWritten) {
  Bench bench;
  std::map<std::string, std::string> kinds;
  const Json list = bench.call("files.list");
  for (const Json& file : list["files"]) kinds[file["path"]] = file["kind"];
  const std::map<std::string, std::string> expected = {
      {"main.awl", "source"}, {"main.sym", "symbols"}, {"merker.toml", "hardware"}};
  EXPECT_EQ(kinds, expected);

  const Json read = bench.call("files.read", {{"path", "main.awl"}});
  EXPECT_EQ(read["text"], kProgram);
  const Json written = bench.call(
      "files.write", {{"path", "main.awl"}, {"text", "// ä\n"}, {"revision", read["revision"]}});
  EXPECT_EQ(bench.folder.read("main.awl"), "// ä\n");
  EXPECT_NE(written["revision"], read["revision"]);
  EXPECT_EQ(bench.call("files.read", {{"path", "main.awl"}})["revision"], written["revision"]);
}

TEST(Files, WhatSomebodyElseSavedIsNotLost) {
  Bench bench;
  const Json read = bench.call("files.read", {{"path", "main.awl"}});
  bench.folder.write("main.awl", "// by another editor\n");
  EXPECT_EQ(bench.problem("files.write",
                          {{"path", "main.awl"}, {"text", "mine"}, {"revision", read["revision"]}}),
            "P1311");
  EXPECT_EQ(bench.folder.read("main.awl"), "// by another editor\n");
}

TEST(Files, AreMadeRenamedAndDeleted) {
  Bench bench;
  bench.call("files.create", {{"path", "lib/deep/new.awl"}});
  EXPECT_TRUE(fs::exists(bench.folder.path("lib/deep/new.awl")));
  EXPECT_EQ(bench.problem("files.create", {{"path", "main.awl"}}), "P1312");
  EXPECT_EQ(bench.problem("files.rename", {{"path", "lib/deep/new.awl"}, {"to", "main.awl"}}),
            "P1312");
  bench.call("files.rename", {{"path", "lib/deep/new.awl"}, {"to", "other.awl"}});
  EXPECT_TRUE(fs::exists(bench.folder.path("other.awl")));
  bench.call("files.delete", {{"path", "other.awl"}});
  bench.folder.write("merker.toml", "[project]\n");
  EXPECT_EQ(bench.problem("files.delete", {{"path", "merker.toml"}}), "P1322");
  EXPECT_EQ(bench.problem("files.rename", {{"path", "merker.toml"}, {"to", "other.toml"}}),
            "P1322");
  EXPECT_FALSE(fs::exists(bench.folder.path("other.awl")));
  EXPECT_EQ(bench.problem("files.delete", {{"path", "other.awl"}}), "P1310");
  EXPECT_EQ(bench.problem("files.read", {{"path", "none.awl"}}), "P1310");
}

std::string foldersAnd(std::size_t count, const std::string& name) {
  std::string path;
  for (std::size_t i = 0; i < count; ++i) path += "a/";
  return path + name;
}

// As deep as a program is looked for: a file below would make the project impossible to compile.
TEST(Files, FoldersTooDeepAreNotMade) {
  Bench bench;
  const std::string last = foldersAnd(project::kDeepestFolder, "x.txt");
  const std::string tooDeep = foldersAnd(project::kDeepestFolder + 1, "x.txt");
  EXPECT_EQ(bench.problem("files.create", {{"path", tooDeep}}), "P1314");
  EXPECT_EQ(bench.problem("files.rename", {{"path", "main.awl"}, {"to", tooDeep}}), "P1314");
  EXPECT_FALSE(fs::exists(bench.folder.path("a")));
  bench.call("files.create", {{"path", last}});
  EXPECT_EQ(bench.problem("files.rename", {{"path", last}, {"to", tooDeep}}), "P1314");
  EXPECT_EQ(bench.call("program.check")["problems"], Json::array());
}

// What somebody made too deep by other means can be taken away here.
TEST(Files, FoldersThatAreEmptyGo) {
  Bench bench;
  const std::string deep = foldersAnd(project::kDeepestFolder + 8, "x.txt");
  bench.folder.write(deep, "x");
  EXPECT_NE(bench.call("program.check")["problems"], Json::array());
  bench.folder.write("a/stays.txt", "x");
  bench.call("files.delete", {{"path", deep}});
  EXPECT_EQ(bench.call("program.check")["problems"], Json::array());
  EXPECT_FALSE(fs::exists(bench.folder.path("a/a")));
  EXPECT_TRUE(fs::exists(bench.folder.path("a/stays.txt")));
  bench.call("files.rename", {{"path", "a/stays.txt"}, {"to", "b/c.txt"}});
  EXPECT_FALSE(fs::exists(bench.folder.path("a")));
  bench.call("files.rename", {{"path", "b/c.txt"}, {"to", "b/d.txt"}});
  bench.call("files.delete", {{"path", "b/d.txt"}});
  EXPECT_FALSE(fs::exists(bench.folder.path("b")));
  EXPECT_TRUE(fs::exists(bench.folder.path("main.awl")));
}

TEST(Files, NoPathLeadsOut) {
  Bench bench;
  bench.folder.write("../" + fs::path(bench.folder.path()).filename().string() + "-secret",
                     "secret");
  const std::string nul("main.awl\0.sym", 13);
  for (const std::string& path :
       {std::string(), std::string("/etc/passwd"), std::string("../x"), std::string("a/../../x"),
        std::string("."), std::string(".."), std::string("a//b"), std::string("a/"),
        std::string(".hidden"), std::string("a/.git/config"), std::string("a\\..\\b"),
        std::string("C:x"), std::string("a\nb"), std::string(500, 'a'), nul}) {
    for (const char* method : {"files.read", "files.delete", "files.create"})
      EXPECT_EQ(bench.problem(method, {{"path", path}}), "P1309") << method << ' ' << path;
    EXPECT_EQ(bench.problem("files.write", {{"path", path}, {"text", ""}, {"revision", 0}}),
              "P1309");
    EXPECT_EQ(bench.problem("files.rename", {{"path", "main.awl"}, {"to", path}}), "P1309");
    EXPECT_EQ(bench.problem("files.rename", {{"path", path}, {"to", "x.awl"}}), "P1309");
  }
  fs::remove(bench.folder.path() + "-secret");
}

TEST(Files, LinksAreNotFollowed) {
  Bench bench;
  Folder outside;
  outside.write("secret.awl", "secret");
  fs::create_symlink(outside.path("secret.awl"), bench.folder.path("link.awl"));
  fs::create_directory_symlink(outside.path(), bench.folder.path("way"));
  EXPECT_EQ(bench.problem("files.read", {{"path", "link.awl"}}), "P1310");
  EXPECT_EQ(bench.problem("files.read", {{"path", "way/secret.awl"}}), "P1310");
  EXPECT_EQ(bench.problem("files.write", {{"path", "link.awl"}, {"text", ""}, {"revision", 0}}),
            "P1310");
  EXPECT_EQ(bench.problem("files.create", {{"path", "way/new.awl"}}), "P1313");
  EXPECT_EQ(bench.problem("files.rename", {{"path", "main.awl"}, {"to", "way/x.awl"}}), "P1313");
  EXPECT_EQ(bench.problem("files.delete", {{"path", "way/secret.awl"}}), "P1310");
  EXPECT_EQ(outside.read("secret.awl"), "secret");
}

TEST(Files, OfASingleSourceAreItsOwn) {
  Folder folder;
  folder.write("main.awl", kProgram);
  folder.write("private.txt", "x");
  Workbench workbench;
  workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(folder.path("main.awl"), {}), false)));
  const auto ask = [&](const std::string& text) { return workbench.handle(1, text); };
  EXPECT_EQ(ask(R"({"id": 1, "do": "files.list"})").find("private"), std::string::npos);
  EXPECT_NE(ask(R"({"id": 1, "do": "files.read", "path": "private.txt"})").find("P1310"),
            std::string::npos);
  EXPECT_NE(ask(R"({"id": 1, "do": "files.create", "path": "new.txt"})").find("P1310"),
            std::string::npos);
  EXPECT_NE(ask(R"({"id": 1, "do": "files.read", "path": "main.awl"})").find("result"),
            std::string::npos);
}

TEST(Files, ChangesByOthersAreSeen) {
  Bench bench;
  const Json before = bench.state();
  EXPECT_EQ(before["project"]["changed"], Json::array());
  bench.folder.write("more.awl", "// new\n");
  for (int frame = 0; frame < 40; ++frame) bench.events();  // more than a second
  const Json after = bench.state();
  EXPECT_GT(after["files"], before["files"]);
  EXPECT_EQ(after["project"]["changed"], Json::array({"more.awl"}));
}

TEST(Files, AProgramListKeepsTheNamesOfItsFiles) {
  Bench bench(kProgram, "[program]\nsources = [\"main.awl\"]  # in this order\n");
  bench.call("files.rename", {{"path", "main.awl"}, {"to", "lib/first.awl"}});
  EXPECT_NE(bench.folder.read("merker.toml").find("[\"lib/first.awl\"]  # in this order"),
            std::string::npos);
  EXPECT_EQ(bench.call("program.check")["problems"], Json::array());
  bench.call("files.delete", {{"path", "lib/first.awl"}});
  EXPECT_NE(bench.folder.read("merker.toml").find("sources = []"), std::string::npos);
}

// Who may read a file stays as it was: what only its owner saw, nobody else sees afterwards.
TEST(Files, AFileKeepsItsRights) {
  namespace fs = std::filesystem;
  Bench bench;
  for (const fs::perms rights : {fs::perms(0600), fs::perms(0640), fs::perms(0755)}) {
    bench.folder.write("notes.awl", "// old\n");
    fs::permissions(bench.folder.path("notes.awl"), rights);
    const Json old = bench.call("files.read", {{"path", "notes.awl"}});
    bench.call("files.write",
               {{"path", "notes.awl"}, {"text", "// new\n"}, {"revision", old["revision"]}});
    EXPECT_EQ(bench.folder.read("notes.awl"), "// new\n");
    EXPECT_EQ(fs::status(bench.folder.path("notes.awl")).permissions(), rights);
  }
}

TEST(Files, WhatIsTooLargeIsNotRead) {
  Bench bench;
  bench.folder.write("big.awl", std::string(9 << 20, '/'));
  EXPECT_EQ(bench.problem("files.read", {{"path", "big.awl"}}), "P1308");
  EXPECT_EQ(bench.problem("files.write", {{"path", "big.awl"}, {"text", ""}, {"revision", 0}}),
            "P1308");
}

// Each of these characters is six in an answer.
TEST(Files, AnAnswerHasALimit) {
  Bench bench;
  bench.folder.write("odd.awl", std::string(2 << 20, '\x01'));
  const std::string code = bench.problem("files.read", {{"path", "odd.awl"}});
  EXPECT_TRUE(code == "P1308" || code == "P0102") << code;
  bench.folder.write("quotes.awl", std::string(5 << 20, '"'));
  EXPECT_EQ(bench.problem("files.read", {{"path", "quotes.awl"}}), "P1308");
}

}  // namespace
}  // namespace merker::workbench::test
