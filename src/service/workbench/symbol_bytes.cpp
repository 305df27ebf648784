#include "workbench/symbol_bytes.h"

#include <optional>

#include "base/code_page.h"
#include "source/symbol_text.h"

namespace merker::workbench {
namespace {

// Calls `visit` with each character beyond ASCII.
template <typename Visit>
void eachForeign(std::string_view utf8, Visit visit) {
  for (std::size_t at = 0; at < utf8.size();) {
    std::size_t end = at + 1;
    while (end < utf8.size() && (static_cast<unsigned char>(utf8[end]) & 0xC0U) == 0x80) ++end;
    if (end > at + 1) visit(utf8.substr(at, end - at));
    at = end;
  }
}

SymbolBytes inPage(unsigned page, std::string_view utf8) {
  Encoder encoder(page);
  SymbolBytes made{encoder.encode(utf8), page};
  eachForeign(utf8, [&](std::string_view one) { made.missing += encoder.bytesOf(one) ? 0 : 1; });
  return made;
}

SymbolBytes inWindows(std::string_view utf8) {
  std::optional<SymbolBytes> best;
  for (const unsigned page : kWindowsPages) {
    SymbolBytes made = inPage(page, utf8);
    if (!best || made.missing < best->missing) best = std::move(made);
    if (best->missing == 0) break;
  }
  return *best;
}

}  // namespace

SymbolBytes symbolBytes(const source::SymbolTable& table, std::string_view extension) {
  constexpr unsigned kDos = 437;
  std::string text = source::symbolText(table, extension, Mnemonics::German);
  if (extension == ".sym") return {std::move(text)};
  const bool dos = extension == ".seq" && table.language() == source::Language::Step5;
  return dos ? inPage(kDos, text) : inWindows(text);
}

std::string storedSymbols(const source::SymbolTable& table, std::string_view extension) {
  SymbolBytes made = symbolBytes(table, extension);
  const bool certain = made.page == 1252 || made.page == 437;
  if (made.missing == 0 && certain) return std::move(made.bytes);
  return source::symbolText(table, extension, Mnemonics::German);
}

}  // namespace merker::workbench
