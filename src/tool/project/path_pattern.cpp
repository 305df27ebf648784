#include "project/path_pattern.h"

#include "base/text.h"

namespace merker::project {

// The one way through pattern and path that is tried: a star stands for as little as possible, and
// when what follows it does not fit, the last star takes one more character, then the last **/ one
// more folder. Stars further back need not take more: what followed them was found at the earliest
// place, which leaves the most to the later ones.
class PathPattern::Way {
 public:
  Way(std::string_view pattern, std::string_view path) : pattern_(pattern), path_(path) {}

  bool ended() const { return here_.pattern == pattern_.size() && here_.path == path_.size(); }
  bool onward() { return folders() || star() || character(); }
  bool back() { return moreCharacters() || moreFolders(); }
  std::uint64_t skipped() const { return skipped_; }

 private:
  static constexpr std::size_t kNone = std::string_view::npos;
  struct Place {
    std::size_t pattern = kNone, path = 0;
  };

  bool folders() {
    const bool first = here_.pattern == 0 || pattern_[here_.pattern - 1] == '/';
    if (!first || !pattern_.substr(here_.pattern).starts_with("**/")) return false;
    here_.pattern += 3;
    folders_ = here_;
    star_ = {};
    return true;
  }

  bool star() {
    if (here_.pattern == pattern_.size() || pattern_[here_.pattern] != '*') return false;
    ++here_.pattern;
    star_ = here_;
    return true;
  }

  bool character() {
    if (here_.pattern == pattern_.size() || here_.path == path_.size()) return false;
    const char wanted = pattern_[here_.pattern], c = path_[here_.path];
    if (wanted != c && (wanted != '?' || c == '/')) return false;
    if (c == '/') star_ = {};
    ++here_.pattern;
    ++here_.path;
    return true;
  }

  bool moreCharacters() {
    if (star_.pattern == kNone || star_.path == path_.size() || path_[star_.path] == '/')
      return false;
    ++star_.path;
    here_ = star_;
    return true;
  }

  bool moreFolders() {
    if (folders_.pattern == kNone) return false;
    const std::size_t slash = path_.find('/', folders_.path);
    if (slash == kNone) return false;
    skipped_ += slash - folders_.path;
    folders_.path = slash + 1;
    here_ = folders_;
    star_ = {};
    return true;
  }

  std::string_view pattern_, path_;
  Place here_{0, 0}, star_, folders_;  // the last two: behind the star, and where it ends by now
  std::uint64_t skipped_ = 0;
};

PathPattern::PathPattern(std::string_view text) : text_(upper(text)) {}

bool PathPattern::matches(std::string_view path, std::uint64_t& steps) const {
  Way way(text_, path);
  bool possible = true;
  for (; possible && !way.ended(); ++steps) possible = way.onward() || way.back();
  steps += way.skipped() + 1;
  return possible;
}

}  // namespace merker::project
