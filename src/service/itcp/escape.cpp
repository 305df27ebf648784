#include "itcp/escape.h"

#include <utility>

namespace merker::itcp {
namespace {

struct EscapedCharacter {
  char character;
  std::string_view text;
};
constexpr EscapedCharacter kHtmlTexts[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
constexpr EscapedCharacter kJsonTexts[] = {{'"', "\\\""}, {'\\', "\\\\"}};

template <std::size_t N>
void add(std::string& out, char c, const EscapedCharacter (&texts)[N]) {
  for (const EscapedCharacter& one : texts)
    if (one.character == c) {
      out += one.text;
      return;
    }
  out += c;
}

}  // namespace

std::string escaped(std::string_view text, Escape how) {
  std::string out;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F')
      out += ' ';
    else if (how == Escape::Html)
      add(out, c, kHtmlTexts);
    else if (how == Escape::Json)
      add(out, c, kJsonTexts);
    else
      out += c;
  }
  return out;
}

}  // namespace merker::itcp
