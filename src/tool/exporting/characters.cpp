#include "exporting/characters.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/code_page.h"

namespace merker::exporting {
namespace {

struct Missing {
  std::string character;
  Position first;
  std::size_t count = 0;
};

// In the order of their first places.
struct Found {
  std::vector<Missing> list;
  std::map<std::string, std::size_t, std::less<>> places;
};

std::size_t lengthOf(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

// Each character beyond ASCII, with what gives its place.
template <typename Visit>
void eachCharacter(const project::Project& project, Visit visit) {
  const auto look = [&](std::string_view text, const auto& placeOf) {
    for (std::size_t at = 0; at < text.size();) {
      const std::string_view character = text.substr(at, lengthOf(text[at]));
      if (static_cast<unsigned char>(text[at]) >= 0x80)
        visit(character, [&] { return placeOf(at, character.size()); });
      at += character.size();
    }
  };
  for (const source::SourceFile& file : project.sources)
    look(file.text(),
         [&](std::size_t at, std::size_t length) { return file.position(at, length); });
  for (const source::Symbol& symbol : project.symbols.list())
    for (const std::string* text : {&symbol.name, &symbol.comment})
      look(*text, [&](std::size_t, std::size_t) { return symbol.position; });
}

std::string placeText(const Position& at) {
  return at.line == 0 ? at.file : fmt::format("{}:{}:{}", at.file, at.line, at.column);
}

}  // namespace

unsigned pageOf(const project::Project& project) {
  std::set<std::string, std::less<>> characters;
  eachCharacter(project, [&](std::string_view character, const auto&) {
    if (!characters.contains(character)) characters.emplace(character);
  });
  unsigned best = kWindowsPages[0];
  std::size_t fewest = characters.size() + 1;
  for (const unsigned page : kWindowsPages) {
    Encoder encoder(page);
    const auto missing = static_cast<std::size_t>(std::ranges::count_if(
        characters, [&](const std::string& c) { return !encoder.bytesOf(c); }));
    if (missing < fewest) best = page;
    fewest = std::min(fewest, missing);
  }
  return best;
}

std::vector<std::string> missingIn(unsigned page, const project::Project& project) {
  Found found;
  Encoder encoder(page);
  eachCharacter(project, [&](std::string_view character, const auto& place) {
    if (encoder.bytesOf(character)) return;
    const auto [at, added] = found.places.try_emplace(std::string(character), found.list.size());
    if (added) found.list.push_back({at->first, place()});
    ++found.list[at->second].count;
  });
  std::vector<std::string> warnings;
  for (const Missing& missing : found.list)
    warnings.push_back(
        fmt::format("{}: warning: '{}' is not in code page {} and is written as '?' ({} {})",
                    placeText(missing.first), missing.character, page, missing.count,
                    missing.count == 1 ? "time" : "times"));
  return warnings;
}

}  // namespace merker::exporting
