#include "s5project/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "s5d/listings.h"
#include "s5project/symbols.h"

namespace merker::s5project {
namespace {

constexpr std::string_view kProgramEnd = "ST.S5D", kListEnd = "Z0.SEQ";

// xxxxxx of "xxxxxxST.S5D", in capital letters; the whole name if it is another one.
std::string stemOf(std::string_view name, std::string_view end) {
  std::string text = upper(name);
  if (text.ends_with(end)) text.resize(text.size() - end.size());
  return text;
}

// What else STEP 5 keeps beside a program (section 3 of the requirements).
struct Companion {
  std::string_view end, what;
};
constexpr std::array kCompanions{Companion{"Z0.INI", "the compiled assignment list"},
                                 Companion{"DO.S5D", "the documentation"},
                                 Companion{"D0.S5D", "the documentation"},
                                 Companion{"PX.INI", "the settings"},
                                 Companion{"XR.INI", "the cross references"},
                                 Companion{"A0.SEQ", "a source for the batch compiler"},
                                 Companion{"BP.SUB", "the bus paths"}};

std::size_t commentsOf(const mc5::Program& program) {
  std::size_t count = 0;
  for (const auto& [id, block] : program) {
    count += block.comments.size();
    count += static_cast<std::size_t>(std::ranges::count_if(
        block.networks, [](const mc5::Network& network) { return !network.title.empty(); }));
  }
  return count;
}

class Maker {
 public:
  explicit Maker(const Input& input) : input_(input) {}

  Output make() {
    const s5d::Contents contents = s5d::readProgram(input_.program, input_.codePage);
    result_.name = projectName(input_.name);
    const Symbols symbols =
        input_.assignments ? readAssignments(*input_.assignments, input_.codePage) : Symbols{};
    s5d::Listings listings = s5d::listings(contents, symbols.table);
    notes(contents.notes);
    notes(listings.notes);
    for (const std::string& text : symbols.notes) note(text);
    if (contents.beyondAscii)
      note(fmt::format("texts were read in code page {}; the other one is {}",
                       input_.codePage == Encoding::Cp850 ? 850 : 437,
                       input_.codePage == Encoding::Cp850 ? 437 : 850),
           false);
    companions();
    result_.blocks = listings.blocks;
    result_.deleted = contents.deleted.size();
    result_.comments = commentsOf(contents.program);
    result_.symbols = symbols.table.list().size();
    if (!result_.usable()) return std::move(result_);
    files(std::move(listings.files), symbols);
    return std::move(result_);
  }

 private:
  void note(std::string text, bool lost = true) {
    result_.notes.push_back({std::move(text), lost});
  }

  void notes(const std::vector<s5d::Note>& list) {
    for (const s5d::Note& one : list)
      note(one.block.empty() ? one.text : one.block + ": " + one.text, one.lost);
  }

  void companions() {
    const std::string stem = stemOf(input_.name, kProgramEnd);
    for (const std::string& file : input_.beside)
      for (const Companion& companion : kCompanions)
        if (upper(file) == stem + std::string(companion.end))
          note(fmt::format("{}: {}; it is not read", file, companion.what));
    if (!input_.assignments)
      note("there is no assignment list (Z0.SEQ); operands are absolute", false);
  }

  void files(std::vector<s5d::ListingFile> listings, const Symbols& symbols) {
    const std::string shown = result_.name + "ST.S5D";
    result_.files.push_back({"merker.toml", settings(result_.name, shown)});
    if (!symbols.text.empty()) result_.files.push_back({"symbols.sym", symbols.text});
    for (s5d::ListingFile& file : listings)
      result_.files.push_back({std::move(file.path), std::move(file.text)});
  }

  const Input& input_;
  Output result_;
};

}  // namespace

std::string settings(const std::string& name, std::string_view file) {
  return fmt::format(
      "# From {}.\n[project]\nname = \"{}\"\n\n[cpu]\nmodel = \"SINUMERIK 810 GA3\"\n", file, name);
}

// Names are filled up to six characters with @.
std::string projectName(std::string_view file) {
  std::string name = stemOf(file, kProgramEnd);
  name = name.substr(0, name.find('.'));
  name.erase(name.find_last_not_of('@') + 1);
  std::erase_if(name, [](char c) { return c < ' ' || c == '"' || c == '\\' || c > '~'; });
  return name.empty() ? "STEP 5" : name;
}

bool recognises(std::span<const std::uint8_t> bytes) { return s5d::isS5d(bytes); }

bool isAssignmentList(std::string_view file, std::string_view program) {
  return upper(file).ends_with(kListEnd) && stemOf(file, kListEnd) == stemOf(program, kProgramEnd);
}

Output makeProject(const Input& input) { return Maker(input).make(); }

}  // namespace merker::s5project
