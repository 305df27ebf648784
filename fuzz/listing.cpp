// STEP 5 listings: any text is compiled or refused with problems that can be shown; what was
// compiled, written as a listing, compiles to the same words.
#include "harness.h"
#include "step5/compiler.h"
#include "step5/variable.h"

using namespace merker;

namespace {

step5::Compilation compile(const std::string& text, bool checks) {
  std::vector<source::SourceFile> sources;
  sources.emplace_back("a.s5", text);
  step5::Compilation compilation = step5::compile(sources, checks);
  for (const Problem& problem : compilation.problems.list())
    (void)source::format(problem, &sources[0]);
  return compilation;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text(data, size);
  const std::string text = toUtf8(bytes, detectEncoding(bytes));
  (void)step5::parseInstruction(text, {"", 1, 1});
  (void)step5::parseVariable(text);
  const step5::Compilation first = compile(text, true);
  if (!first.ok()) return 0;
  const step5::Compilation again = compile(step5::listing(first.program), false);
  for (const auto& [id, block] : first.program) {
    const auto found = again.program.find(id);
    fuzz::require(found != again.program.end() && found->second.words == block.words,
                  "a listing of a program compiles to the same words");
  }
  return 0;
}
