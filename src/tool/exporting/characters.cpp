#include "exporting/characters.h"

#include <fmt/format.h>

#include <map>

#include "base/text.h"

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

template <typename PlaceOf>
void look(std::string_view text, Found& found, const PlaceOf& placeOf) {
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view character = text.substr(at, lengthOf(text[at]));
    if (static_cast<unsigned char>(text[at]) >= 0x80 && toCp1252(character) == "?") {
      const auto [place, added] =
          found.places.try_emplace(std::string(character), found.list.size());
      if (added) found.list.push_back({place->first, placeOf(at, character.size())});
      ++found.list[place->second].count;
    }
    at += character.size();
  }
}

std::string placeText(const Position& at) {
  return at.line == 0 ? at.file : fmt::format("{}:{}:{}", at.file, at.line, at.column);
}

}  // namespace

std::vector<std::string> missingInCp1252(const project::Project& project) {
  Found found;
  for (const source::SourceFile& file : project.sources)
    look(file.text(), found,
         [&](std::size_t at, std::size_t length) { return file.position(at, length); });
  for (const source::Symbol& symbol : project.symbols.list())
    for (const std::string* text : {&symbol.name, &symbol.comment})
      look(*text, found, [&](std::size_t, std::size_t) { return symbol.position; });
  std::vector<std::string> warnings;
  for (const Missing& missing : found.list)
    warnings.push_back(
        fmt::format("{}: warning: '{}' is not in code page 1252 and is written as '?' ({} {})",
                    placeText(missing.first), missing.character, missing.count,
                    missing.count == 1 ? "time" : "times"));
  return warnings;
}

}  // namespace merker::exporting
