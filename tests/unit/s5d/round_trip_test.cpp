// A listing becomes an S5D file and the file a listing (docs/formats/s5d.md).
#include <algorithm>
#include <filesystem>

#include "program.h"
#include "source/dos_text.h"

namespace merker::s5d {
namespace {

namespace fs = std::filesystem;

// The listings of each folder below `folder`, which are one program together.
std::map<fs::path, std::vector<source::SourceFile>> programs(const fs::path& folder) {
  std::map<fs::path, std::vector<source::SourceFile>> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".s5") {
      const bool project = fs::exists(entry.path().parent_path() / "merker.toml");
      const fs::path key = project ? entry.path().parent_path() : entry.path();
      auto file = source::readSource(entry.path().string());
      if (file) found[key].push_back(std::move(file.value()));
    }
  return found;
}

source::SymbolTable symbolsOf(const fs::path& folder) {
  source::SymbolTable table(source::Language::Step5);
  Problems problems;
  for (const auto& entry : fs::directory_iterator(folder))
    if (source::isSymbolFile(entry.path().string()))
      readSymbols(*source::readSource(entry.path().string()), table, problems);
  return table;
}

// All comments and titles without their marks, sorted.
std::vector<std::string> texts(const mc5::Program& program) {
  std::vector<std::string> list;
  const auto add = [&list](const std::string& text) {
    const std::size_t begin = std::min(text.find_first_not_of("!;/ "), text.size());
    // What the code page does not have cannot come back.
    const std::string bytes = source::toDos(text.substr(begin), Encoding::Cp850);
    if (!bytes.empty()) list.push_back(toUtf8(bytes, Encoding::Cp850));
  };
  for (const auto& [id, block] : program) {
    for (const std::string& text : block.heading) add(text);
    for (const mc5::Comment& comment : block.comments) add(comment.text);
    for (const mc5::Network& network : block.networks) add(network.title);
  }
  std::ranges::sort(list);
  return list;
}

void compare(const mc5::Program& was, const mc5::Program& is) {
  ASSERT_EQ(was.size(), is.size());
  for (const auto& [id, block] : was) {
    const mc5::Block& back = is.at(id);
    EXPECT_EQ(block.words, back.words);
    EXPECT_EQ(block.formats, back.formats);
    EXPECT_EQ(block.name, back.name);
    EXPECT_EQ(block.library, back.library);
    ASSERT_EQ(block.parameters.size(), back.parameters.size());
    for (std::size_t i = 0; i < block.parameters.size(); ++i) {
      EXPECT_EQ(block.parameters[i].name, back.parameters[i].name);
      EXPECT_EQ(block.parameters[i].kind, back.parameters[i].kind);
      EXPECT_EQ(block.parameters[i].width, back.parameters[i].width);
      EXPECT_EQ(block.parameters[i].format, back.parameters[i].format);
    }
    if (id.type == mc5::BlockType::Fb) {
      EXPECT_EQ(block.labels, back.labels);
    }
  }
  EXPECT_EQ(texts(was), texts(is));
}

TEST(RoundTrip, EveryExampleComesBack) {
  const auto all = programs(fs::path(MERKER_SOURCE_DIR) / "examples" / "step5");
  EXPECT_GE(all.size(), 20u);
  for (const auto& [path, files] : all) {
    SCOPED_TRACE(path.string());
    const source::SymbolTable symbols =
        symbolsOf(fs::is_directory(path) ? path : path.parent_path());
    const step5::Compilation first = step5::compile(files, true, {}, &symbols);
    ASSERT_FALSE(first.program.empty());
    const auto file = writeProgram(first.program, "EXAMPLE", Encoding::Cp850);
    const Contents back = readProgram(file, Encoding::Cp850);
    for (const Note& note : back.notes) ADD_FAILURE() << note.block << ": " << note.text;
    compare(first.program, back.program);
    // And once more as text: S5D -> listing -> S5D gives the same code.
    const step5::Compilation again =
        step5::compile({source::SourceFile("t.s5", step5::listing(back.program))}, true);
    if (first.ok()) {
      for (const Problem& p : again.problems.list())
        if (p.severity() == Severity::Error) ADD_FAILURE() << p.name() << p.position.line;
    }
    for (const auto& [id, block] : again.program) EXPECT_EQ(block.words, back.program.at(id).words);
  }
}

TEST(RoundTrip, LibraryNumberNamesAndKindsOfParametersComeBack) {
  const std::string text =
      "FB 7   VENTIL   BIB=14050\nBEZ  : EIN   E/A/D/B/T/Z: E  BI/BY/W/D: BI\n"
      "BEZ  : BY    E/A/D/B/T/Z: E  BI/BY/W/D: BY\nBEZ  : WO    E/A/D/B/T/Z: A  BI/BY/W/D: W\n"
      "BEZ  : DO    E/A/D/B/T/Z: A  BI/BY/W/D: D\nBEZ  : GK    E/A/D/B/T/Z: D  "
      "KM/KH/KY/KC/KT/KZ/KF/KG: KG\nBEZ  : KM    E/A/D/B/T/Z: D  KM/KH/KY/KC/KT/KZ/KF/KG: KM\n"
      "BEZ  : BST   E/A/D/B/T/Z: B\nBEZ  : ZEIT  E/A/D/B/T/Z: T\nBEZ  : ZAEL  E/A/D/B/T/Z: Z\n"
      "     : BE\n\n";
  EXPECT_EQ(cameBack(text), step5::listing(programOf(text)));
}

TEST(RoundTrip, FormatsOfDataWordsComeBack) {
  const std::string text =
      "DB 10\n    0: KH 1F00\n    1: KF +5\n    2: KF -7\n    3: KM 00000000 11111111\n"
      "    4: KG +1234567+02\n    6: KG -1000000+01\n    8: KY 1,2\n    9: KT 10.2\n"
      "   10: KZ 7\n   11: KC 'AB'\n   12: KS 'HALLO WELT'\n   17: KS 'XY12'\n   19: KH 0000\n\n";
  EXPECT_EQ(cameBack(text), step5::listing(programOf(text)));
}

TEST(RoundTrip, MoreThan255BlocksTakeSeveralSections) {
  std::string text;
  for (int i = 1; i <= 200; ++i)
    text += "PB " + std::to_string(i) + "\nNETZWERK 1 T" + std::to_string(i) + "\n BE\n";
  const auto file = fileOf(text);
  EXPECT_EQ(file[22], 2);
  const Contents back = readProgram(file, Encoding::Cp437);
  EXPECT_EQ(back.program.size(), 200u);
  EXPECT_EQ(back.program.at({mc5::BlockType::Pb, 199}).networks.at(0).title, "T199");
}

}  // namespace
}  // namespace merker::s5d
