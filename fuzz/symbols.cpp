// Symbol files: the first byte chooses format and language, the rest is the file in any encoding.
#include <array>

#include "harness.h"
#include "source/symbol_table.h"

using namespace merker;

namespace {

constexpr std::array<const char*, 5> kExtensions{".sym", ".sdf", ".asc", ".dif", ".seq"};

Problems read(const char* extension, std::string_view bytes, source::SymbolTable& table) {
  Problems problems;
  const source::SourceFile file(std::string("a") + extension, toUtf8(bytes, detectEncoding(bytes)));
  source::readSymbols(file, table, problems);
  for (const Problem& problem : problems.list()) (void)source::format(problem, &file);
  return problems;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto language =
      data[0] / kExtensions.size() % 2 == 0 ? source::Language::Step7 : source::Language::Step5;
  source::SymbolTable table(language);
  const Problems problems =
      read(kExtensions[data[0] % kExtensions.size()], fuzz::text(data + 1, size - 1), table);
  for (const char* extension : kExtensions)
    (void)source::writeSymbols(table, extension, Mnemonics::German);
  if (problems.hasErrors()) return 0;

  source::SymbolTable again(language);
  const std::string text = source::writeSymbols(table, ".sym", Mnemonics::International);
  const source::SourceFile file("a.sym", text);
  Problems none;
  source::readSymbols(file, again, none);
  fuzz::require(!none.hasErrors() && again.list().size() == table.list().size(),
                "a table reads back");
  return 0;
}
