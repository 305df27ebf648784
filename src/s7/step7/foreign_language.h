// Sources of the other languages of STEP 7: SCL and GRAPH begin their blocks with the same words.
#pragma once

#include <optional>
#include <stop_token>
#include <string_view>

namespace merker::step7 {

struct ForeignText {
  std::string_view language;       // "SCL"
  std::string_view refusal;        // for a problem
  std::size_t begin = 0, end = 0;  // the word that tells it
};

// Nothing if no statement begins with a word that only SCL or GRAPH has.
std::optional<ForeignText> foreignText(std::string_view source, const std::stop_token& stop = {});

}  // namespace merker::step7
