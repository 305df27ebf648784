// Text between two tags of XML.
#pragma once

#include <string>
#include <string_view>

namespace merker {

// Control characters cannot be written at all.
inline std::string xmlText(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

}  // namespace merker
