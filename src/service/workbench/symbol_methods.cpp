// The symbol table of the project (S7-SYM).
#include <algorithm>

#include "project/files.h"
#include "source/symbol_text.h"
#include "workbench/base64.h"
#include "workbench/elsewhere.h"
#include "workbench/symbol_bytes.h"
#include "workbench/symbol_rows.h"

namespace merker::workbench {
namespace symbol_methods {
namespace {

using monitor::Feature;

constexpr std::size_t kMostRows = 20000;
constexpr const char* kNewFile = "symbols.sym";

// The project's symbol file; of several the first one. A project without one gets one.
std::string symbolPath(const Offline& offline, const ProjectFolder& folder) {
  for (const source::SourceFile& file : offline.build->project.otherFiles)
    if (source::isSymbolFile(file.name())) return folder.relative(file.name());
  return kNewFile;
}

std::string extensionOf(const std::string& path) {
  for (const char* extension : {".sdf", ".asc", ".seq", ".dif"})
    if (project::hasExtension(path, extension)) return extension;
  return ".sym";
}

// What is offline is not compiled yet in a fresh workbench; the program of the CPU is.
source::Language languageOf(const Call& call) {
  const OfflineRef offline = call.shared.offlineRef();
  const compilation::Build& build = offline ? *offline->build : call.plc().build();
  return build.project.symbols.language();
}

Json rowsOf(const source::SymbolTable& table) {
  Json rows = Json::array();
  for (const source::Symbol& symbol : table.list())
    rows.push_back(toJson(symbolRow(symbol, table.language())));
  return rows;
}

Answer read(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef(),
                    language = languageOf(call)](const Aside& aside) -> Answer {
                     if (auto gone = aside.folder.missing()) return one(std::move(*gone));
                     const std::string path = symbolPath(*offline, aside.folder);
                     const auto content = aside.folder.read(path);
                     if (!content)
                       return Json{{"path", path},
                                   {"rows", Json::array()},
                                   {"revision", 0},
                                   {"problems", Json::array()}};
                     source::SymbolTable table(language);
                     Problems problems;
                     source::readSymbols(source::SourceFile(path, content->text), table, problems);
                     return Json{{"path", path},
                                 {"rows", rowsOf(table)},
                                 {"revision", content->revision},
                                 {"problems", firstOf(problems)}};
                   });
}

std::vector<SymbolRow> rows(const Fields& fields) {
  std::vector<SymbolRow> list;
  for (const Fields& row : fields.objects("rows", kMostRows))
    list.push_back(
        {row.text("symbol"), row.text("operand"), row.text("type", ""), row.text("comment", "")});
  return list;
}

Answer check(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [language = languageOf(call)](const Aside& aside) -> Answer {
                     const auto wanted = rows(aside.fields);
                     if (!aside.fields.good()) return aside.wrong();
                     return Json{{"problems", toJson(checkRows(wanted, language).problems)}};
                   });
}

Answer write(const Call& call) {
  return changingFiles(
      call,
      [offline = call.shared.offlineRef(),
       language = languageOf(call)](const Aside& aside) -> Answer {
        const auto wanted = rows(aside.fields);
        const std::int64_t revision = aside.fields.integer("revision", 0, INT64_MAX, 0);
        if (!aside.fields.good()) return aside.wrong();
        const CheckedRows checked = checkRows(wanted, language);
        if (!checked.good()) return Answer::refused(toJson(checked.problems));
        const std::string path = symbolPath(*offline, aside.folder);
        const std::string bytes = storedSymbols(checked.table, extensionOf(path));
        const auto problem = revision == 0 ? aside.folder.create(path, bytes)
                                           : aside.folder.write(path, bytes, revision);
        if (problem) return one(*problem);
        return Json{{"revision", revisionOf(bytes)}};
      });
}

std::string format(const Fields& fields) {
  constexpr const char* kFormats[] = {".asc", ".sdf", ".dif", ".seq", ".sym"};
  return kFormats[fields.choice("format", {"asc", "sdf", "dif", "seq", "sym"})];
}

// As many rows as a table may have: more could not be saved.
Answer import(const Call& call) {
  return elsewhere(
      call, call.shared.clerk, [language = languageOf(call)](const Aside& aside) -> Answer {
        const std::string extension = format(aside.fields), text = aside.fields.text("text");
        if (!aside.fields.good()) return aside.wrong();
        source::SymbolTable table(language);
        Problems problems;
        source::readSymbols(source::SourceFile("import" + extension, text), table, problems);
        if (table.list().size() > kMostRows)
          return refused(ProblemCode::P1314, kMostRows, "symbols in a table");
        return Json{{"rows", rowsOf(table)}, {"problems", firstOf(problems)}};
      });
}

// These rows, or the table of the project: the text, and the bytes of the file.
Answer exportAs(const Call& call) {
  return elsewhere(
      call, call.shared.clerk,
      [offline = call.shared.offlineRef(),
       language = languageOf(call)](const Aside& aside) -> Answer {
        const std::string extension = format(aside.fields);
        const bool given = aside.fields.has("rows");
        const auto wanted = given ? rows(aside.fields) : std::vector<SymbolRow>();
        if (!aside.fields.good()) return aside.wrong();
        const CheckedRows checked = checkRows(wanted, language);
        if (!checked.good()) return Answer::refused(toJson(checked.problems));
        const source::SymbolTable& table = given ? checked.table : offline->build->project.symbols;
        const SymbolBytes made = symbolBytes(table, extension);
        return Json{{"text", source::symbolText(table, extension, Mnemonics::German)},
                    {"data", toBase64({reinterpret_cast<const std::uint8_t*>(made.bytes.data()),
                                       made.bytes.size()})},
                    {"codePage", made.page},
                    {"missing", made.missing}};
      });
}

constexpr Method kMethods[] = {
    {"symbols.read", Needs::able(Feature::Symbols), read, Kind::Compiled},
    {"symbols.check", Needs::able(Feature::Symbols), check},
    {"symbols.write", Needs::able(Feature::Symbols), write, Kind::Compiled},
    {"symbols.import", Needs::able(Feature::Symbols), import},
    {"symbols.export", Needs::able(Feature::Symbols), exportAs, Kind::Compiled},
};

}  // namespace
}  // namespace symbol_methods

std::span<const Method> symbolMethods() { return symbol_methods::kMethods; }

}  // namespace merker::workbench
