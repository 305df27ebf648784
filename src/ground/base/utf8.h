// Single characters out of and into UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace merker {

inline constexpr char32_t kReplacement = 0xFFFD;

// The character at `position`, which moves behind it. A byte that begins no valid sequence gives
// U+FFFD and is passed alone. `position` must be inside the text.
char32_t nextCharacter(std::string_view utf8, std::size_t& position);
void appendCharacter(std::string& utf8, char32_t character);
bool isValidUtf8(std::string_view text);
bool isAscii(std::string_view text);

}  // namespace merker
