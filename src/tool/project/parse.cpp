#include "project/parse.h"

#include <fmt/format.h>

#include "project/deep_key.h"

namespace merker::project {

std::optional<toml::table> parseToml(const source::SourceFile& file, Problems& problems) {
  constexpr std::size_t kMegabyte = 1024 * 1024, kLargest = 1;
  if (file.text().size() > kLargest * kMegabyte) {
    problems.add(ProblemCode::P0103, Position{file.name()}, kLargest, "a project file");
    return std::nullopt;
  }
  if (const auto place = deepKey(file.text())) {
    problems.add(ProblemCode::P0202, file.position(*place), "the nesting of keys",
                 fmt::format("1..{}", kDeepestKey));
    return std::nullopt;
  }
  toml::parse_result result = toml::parse(file.text(), file.name());
  if (result) return std::move(result).table();
  const toml::source_position& place = result.error().source().begin;
  problems.add(ProblemCode::P0702, Position{file.name(), place.line, place.column},
               std::string(result.error().description()));
  return std::nullopt;
}

}  // namespace merker::project
