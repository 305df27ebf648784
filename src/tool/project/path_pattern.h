// Patterns of file paths, as merker.toml lists them: * and ? within one name, **/ over any number
// of folders ("lib/**/*.awl" also finds lib/a.awl). Case does not matter, as on the disks that
// STEP 7 projects come from.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace merker::project {

class PathPattern {
 public:
  explicit PathPattern(std::string_view text);

  // `path` is in upper case. What was compared is added to `steps`: stars that stand for much cost
  // more, up to the lengths of path and pattern multiplied for each folder.
  bool matches(std::string_view path, std::uint64_t& steps) const;

 private:
  class Way;
  std::string text_;
};

}  // namespace merker::project
