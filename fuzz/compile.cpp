// AWL sources: any text is compiled or refused with problems that can be shown; what was compiled
// can be listed.
#include "harness.h"
#include "mc7/disassembly.h"
#include "step7/compiler.h"

using namespace merker;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text(data, size);
  std::vector<source::SourceFile> sources;
  sources.emplace_back("a.awl", toUtf8(bytes, detectEncoding(bytes)));
  step7::CompileOptions options;
  options.model = findCpuModel("generic");
  options.checks = true;
  const step7::Compilation compilation = step7::compile(sources, options);
  for (const Problem& problem : compilation.problems.list())
    (void)source::format(problem, &sources[0]);

  for (const auto& [id, block] : compilation.program)
    for (const mc7::Line& line : mc7::disassemble(block.code, Mnemonics::German))
      fuzz::require(line.kind != mc7::LineKind::Illegal,
                    "compiled code has no illegal instruction");
  return 0;
}
