#include "itcp/page_template.h"

#include <fmt/format.h>

namespace merker::itcp {
namespace {

constexpr std::string_view kBegin = ":=";

// Where the ':' behind a name is; npos: this is no name. Between quotation marks it may have one.
std::size_t endOfName(std::string_view text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size() && i <= PageTemplate::kLongestName; ++i) {
    const char c = text[i];
    if (static_cast<unsigned char>(c) < ' ' || c == '<' || c == '>') break;
    if (c == '"') quoted = !quoted;
    if (c == ' ' && i == 0) break;
    if (c == ':' && !quoted) return i == 0 ? std::string_view::npos : i;
  }
  return std::string_view::npos;
}

std::string shown(const PageValue& value, Escape how) {
  if (value.there) return escaped(value.text, how);
  return how == Escape::Json ? "null" : escaped(fmt::format("[{}]", value.text), how);
}

}  // namespace

PageTemplate split(std::string_view page) {
  PageTemplate result;
  std::size_t begin = 0, at = 0;
  while (result.names.size() < PageTemplate::kMostNames) {
    at = page.find(kBegin, at);
    if (at == std::string_view::npos) break;
    const std::string_view behind = page.substr(at + kBegin.size());
    const std::size_t end = endOfName(behind);
    if (end == std::string_view::npos) {
      at += kBegin.size();
      continue;
    }
    result.texts.push_back(page.substr(begin, at - begin));
    result.names.emplace_back(behind.substr(0, end));
    begin = at += kBegin.size() + end + 1;
  }
  result.texts.push_back(page.substr(begin));
  return result;
}

std::string fill(const PageTemplate& page, const std::vector<PageValue>& values, Escape how) {
  std::string text(page.texts.front());
  for (std::size_t i = 0; i < page.names.size(); ++i) {
    text += shown(values[i], how);
    text += page.texts[i + 1];
  }
  return text;
}

}  // namespace merker::itcp
