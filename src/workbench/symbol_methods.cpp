// The symbol table of the project (S7-SYM).
#include <algorithm>

#include "project/files.h"
#include "workbench/method.h"
#include "workbench/symbol_rows.h"

namespace merker::workbench {
namespace {

constexpr std::size_t kMostRows = 20000;
constexpr const char* kNewFile = "symbols.sym";

// The project's symbol file; of several the first one. A project without one gets one.
std::string symbolPath(const Call& call) {
  for (const source::SourceFile& file : call.shared.offline().build.project.otherFiles)
    if (source::isSymbolFile(file.name())) return call.shared.folder.relative(file.name());
  return kNewFile;
}

std::string extensionOf(const std::string& path) {
  for (const char* extension : {".sdf", ".asc", ".seq", ".dif"})
    if (project::hasExtension(path, extension)) return extension;
  return ".sym";
}

Json rowsOf(const source::SymbolTable& table) {
  Json rows = Json::array();
  for (const source::Symbol& symbol : table.list()) rows.push_back(toJson(symbolRow(symbol)));
  return rows;
}

Answer read(const Call& call) {
  const std::string path = symbolPath(call);
  const auto content = call.shared.folder.read(path);
  if (!content) return Json{{"path", path}, {"rows", Json::array()}, {"revision", 0}};
  source::SymbolTable table;
  Problems ignored;  // program.check tells them
  source::readSymbols(source::SourceFile(path, content->text), table, ignored);
  return Json{{"path", path}, {"rows", rowsOf(table)}, {"revision", content->revision}};
}

std::vector<SymbolRow> rows(const Call& call) {
  std::vector<SymbolRow> list;
  for (const Fields& row : call.fields.objects("rows", kMostRows))
    list.push_back(
        {row.text("symbol"), row.text("operand"), row.text("type", ""), row.text("comment", "")});
  return list;
}

Answer check(const Call& call) {
  const auto wanted = rows(call);
  if (!call.fields.good()) return call.fields.problems();
  return Json{{"problems", toJson(checkRows(wanted).problems)}};
}

Answer write(const Call& call) {
  const auto wanted = rows(call);
  const std::int64_t revision = call.fields.integer("revision", 0, INT64_MAX, 0);
  if (!call.fields.good()) return call.fields.problems();
  const CheckedRows checked = checkRows(wanted);
  if (!checked.good()) return Answer::refused(toJson(checked.problems));
  const std::string path = symbolPath(call);
  const std::string bytes =
      source::writeSymbols(checked.table, extensionOf(path), Mnemonics::German);
  const auto problem = revision == 0 ? call.shared.folder.create(path, bytes)
                                     : call.shared.folder.write(path, bytes, revision);
  call.shared.lookAtFiles();
  if (problem) return one(*problem);
  return Json{{"revision", revisionOf(bytes)}};
}

std::string format(const Call& call) {
  constexpr const char* kFormats[] = {".asc", ".sdf", ".dif", ".seq", ".sym"};
  return kFormats[call.fields.choice("format", {"asc", "sdf", "dif", "seq", "sym"})];
}

Answer import(const Call& call) {
  const std::string extension = format(call), text = call.fields.text("text");
  if (!call.fields.good()) return call.fields.problems();
  source::SymbolTable table;
  Problems problems;
  source::readSymbols(source::SourceFile("import" + extension, text), table, problems);
  return Json{{"rows", rowsOf(table)}, {"problems", toJson(problems)}};
}

// These rows, or the table of the project. CP1252 on a disk; a text here.
Answer exportAs(const Call& call) {
  const std::string extension = format(call);
  const bool given = call.fields.has("rows");
  const auto wanted = given ? rows(call) : std::vector<SymbolRow>();
  if (!call.fields.good()) return call.fields.problems();
  const CheckedRows checked = checkRows(wanted);
  if (!checked.good()) return Answer::refused(toJson(checked.problems));
  const source::SymbolTable& table =
      given ? checked.table : call.shared.offline().build.project.symbols;
  const std::string bytes = source::writeSymbols(table, extension, Mnemonics::German);
  return Json{{"text", toUtf8(bytes, detectEncoding(bytes))}};
}

constexpr Method kMethods[] = {
    {"symbols.read", Needs::S7, read, Kind::Compiled},       {"symbols.check", Needs::S7, check},
    {"symbols.write", Needs::S7, write, Kind::Compiled},     {"symbols.import", Needs::S7, import},
    {"symbols.export", Needs::S7, exportAs, Kind::Compiled},
};

}  // namespace

std::span<const Method> symbolMethods() { return kMethods; }

}  // namespace merker::workbench
