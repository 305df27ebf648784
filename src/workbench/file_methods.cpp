// The files of the project folder.
#include "project/settings_edit.h"
#include "workbench/method.h"

namespace merker::workbench {
namespace {

// Whatever came of it, the folder may look different now.
Answer afterwards(const Call& call, std::optional<Problem> problem, Json result = Json::object()) {
  call.shared.lookAtFiles();
  if (problem) return one(std::move(*problem));
  return result;
}

Answer list(const Call& call) {
  call.shared.lookAtFiles();
  Json files = Json::array();
  for (const auto& [path, stamp] : call.shared.files.files())
    files.push_back({{"path", path}, {"size", stamp.size}, {"kind", kindOfFile(path)}});
  return Json{{"files", std::move(files)}};
}

Answer read(const Call& call) {
  const std::string path = call.fields.text("path");
  if (!call.fields.good()) return call.fields.problems();
  const auto content = call.shared.folder.read(path);
  if (!content) return one(content.error());
  return Json{{"text", content->text}, {"revision", content->revision}};
}

Answer write(const Call& call) {
  const std::string path = call.fields.text("path"), text = call.fields.text("text");
  const std::int64_t revision = call.fields.integer("revision", 0, INT64_MAX);
  if (!call.fields.good()) return call.fields.problems();
  return afterwards(call, call.shared.folder.write(path, text, revision),
                    {{"revision", revisionOf(text)}});
}

Answer create(const Call& call) {
  const std::string path = call.fields.text("path"), text = call.fields.text("text", "");
  if (!call.fields.good()) return call.fields.problems();
  return afterwards(call, call.shared.folder.create(path, text), {{"revision", revisionOf(text)}});
}

constexpr const char* kSettings = "merker.toml";

std::optional<Problem> checkMovable(const std::string& path) {
  return path == kSettings ? std::optional(makeProblem(ProblemCode::P1322, nowhere(), path))
                           : std::nullopt;
}

// merker.toml lists files by name: what it says follows them.
std::optional<Problem> keepSettings(const Call& call, const std::string& path,
                                    const std::string& to) {
  const auto settings = call.shared.folder.read(kSettings);
  if (!settings) return std::nullopt;
  project::SettingsEdit edit(kSettings, settings->text);
  to.empty() ? edit.removeFile(path) : edit.renameFile(path, to);
  if (edit.text() == settings->text) return std::nullopt;
  return call.shared.folder.write(kSettings, edit.text(), settings->revision);
}

Answer remove(const Call& call) {
  const std::string path = call.fields.text("path");
  if (!call.fields.good()) return call.fields.problems();
  auto problem = checkMovable(path);
  if (!problem) problem = call.shared.folder.remove(path);
  if (!problem) problem = keepSettings(call, path, {});
  return afterwards(call, std::move(problem));
}

Answer rename(const Call& call) {
  const std::string path = call.fields.text("path"), to = call.fields.text("to");
  if (!call.fields.good()) return call.fields.problems();
  auto problem = checkMovable(path);
  if (!problem) problem = call.shared.folder.rename(path, to);
  if (!problem) problem = keepSettings(call, path, to);
  return afterwards(call, std::move(problem));
}

constexpr Method kMethods[] = {
    {"files.list", Needs::Plc, list},     {"files.read", Needs::Plc, read},
    {"files.write", Needs::Plc, write},   {"files.create", Needs::Plc, create},
    {"files.delete", Needs::Plc, remove}, {"files.rename", Needs::Plc, rename},
};

}  // namespace

std::span<const Method> fileMethods() { return kMethods; }

}  // namespace merker::workbench
