#include "workbench/network_text.h"

namespace merker::workbench {
namespace {

Result<std::string, Problems> typedOrSaved(const Aside& aside, const std::string& path) {
  if (aside.fields.has("text")) return aside.fields.text("text");
  auto content = aside.folder.read(path);
  if (!content) return one(content.error());
  return std::move(content->text);
}

}  // namespace

Result<NetworkText, Problems> networkText(const Aside& aside, const compilation::Build& build) {
  const std::string path = aside.fields.text("file");
  if (!aside.fields.good()) return aside.fields.problems();
  auto text = typedOrSaved(aside, path);
  if (!text) return text.error();
  if (!aside.fields.good()) return aside.fields.problems();
  networks::Surroundings around{.language = build.project.symbols.language(),
                                .symbols = &build.project.symbols,
                                .program = build.program.get(),
                                .library = build.library.get(),
                                .mnemonics = build.project.mnemonics};
  if (build.isListing()) around.language = source::Language::Step5;
  return NetworkText{source::SourceFile(path, std::move(*text)), around};
}

std::int64_t networkLine(const Fields& fields) {
  return fields.integer("line", 1, std::numeric_limits<std::int32_t>::max());
}

graph::Language networkLanguage(const Fields& fields) {
  return static_cast<graph::Language>(fields.choice("language", {"german", "english"}, 0));
}

}  // namespace merker::workbench
