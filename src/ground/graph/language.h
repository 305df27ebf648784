// The languages in which networks are named, said and refused.
#pragma once

#include <cstdint>
#include <string_view>

namespace merker::graph {

enum class Language : std::uint8_t { German, English };

struct Sentence {
  std::string_view english, german;
  constexpr std::string_view in(Language language) const {
    return language == Language::German ? german : english;
  }
};

}  // namespace merker::graph
