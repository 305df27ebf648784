// The files of the project folder.
#include "project/settings_edit.h"
#include "workbench/elsewhere.h"
#include "workbench/hardware_plan.h"

namespace merker::workbench {
namespace file_methods {
namespace {

Answer outcome(std::optional<Problem> problem, Json result = Json::object()) {
  if (problem) return one(std::move(*problem));
  return result;
}

Answer rows(const Listing& seen) {
  Json files = Json::array();
  for (const auto& [path, stamp] : seen)
    files.push_back({{"path", path}, {"size", stamp.size}, {"kind", kindOfFile(path)}});
  return Json{{"files", std::move(files)}};
}

struct Listed {
  Answer answer;
  Listing seen;
};

Answer list(const Call& call) {
  const std::uint64_t number = call.shared.nextLook();
  return elsewhere<Listed>(
      call, call.shared.clerk,
      [](const Aside& aside) {
        if (auto gone = aside.folder.missing()) return Listed{one(std::move(*gone)), {}};
        Listing seen = aside.folder.list();
        Answer answer = written(rows(seen), aside.folder);
        return Listed{std::move(answer), std::move(seen)};
      },
      [number](const Call& now, Listed& listed) {
        now.shared.take(number, std::move(listed.seen));
        return std::move(listed.answer);
      });
}

Answer read(const Call& call) {
  return elsewhere(call, call.shared.clerk, [](const Aside& aside) -> Answer {
    const std::string path = aside.fields.text("path");
    if (!aside.fields.good()) return aside.wrong();
    const auto content = aside.folder.read(path);
    if (!content) return one(content.error());
    return Json{{"text", content->text}, {"revision", content->revision}};
  });
}

Answer write(const Call& call) {
  return changingFiles(call, [](const Aside& aside) -> Answer {
    const std::string path = aside.fields.text("path"), text = aside.fields.text("text");
    const std::int64_t revision = aside.fields.integer("revision", 0, INT64_MAX);
    if (!aside.fields.good()) return aside.wrong();
    return outcome(aside.folder.write(path, text, revision), {{"revision", revisionOf(text)}});
  });
}

Answer create(const Call& call) {
  return changingFiles(call, [](const Aside& aside) -> Answer {
    const std::string path = aside.fields.text("path"), text = aside.fields.text("text", "");
    if (!aside.fields.good()) return aside.wrong();
    return outcome(aside.folder.create(path, text), {{"revision", revisionOf(text)}});
  });
}

constexpr const char* kSettings = "merker.toml";

std::optional<Problem> checkMovable(const std::string& path) {
  return path == kSettings ? std::optional(makeProblem(ProblemCode::P1322, nowhere(), path))
                           : std::nullopt;
}

// merker.toml lists files by name: what it says follows them.
std::optional<Problem> keepSettings(const ProjectFolder& folder, const std::string& path,
                                    const std::string& to) {
  const auto settings = folder.read(kSettings);
  if (!settings || settings->text.size() > kLongestSettings) return std::nullopt;
  project::SettingsEdit edit(kSettings, settings->text);
  to.empty() ? edit.removeFile(path) : edit.renameFile(path, to);
  if (edit.text() == settings->text) return std::nullopt;
  return folder.write(kSettings, edit.text(), settings->revision);
}

Answer remove(const Call& call) {
  return changingFiles(call, [](const Aside& aside) -> Answer {
    const std::string path = aside.fields.text("path");
    if (!aside.fields.good()) return aside.wrong();
    auto problem = checkMovable(path);
    if (!problem) problem = aside.folder.remove(path);
    if (!problem) problem = keepSettings(aside.folder, path, {});
    return outcome(std::move(problem));
  });
}

Answer rename(const Call& call) {
  return changingFiles(call, [](const Aside& aside) -> Answer {
    const std::string path = aside.fields.text("path"), to = aside.fields.text("to");
    if (!aside.fields.good()) return aside.wrong();
    auto problem = checkMovable(path);
    if (!problem) problem = aside.folder.rename(path, to);
    if (!problem) problem = keepSettings(aside.folder, path, to);
    return outcome(std::move(problem));
  });
}

constexpr Method kMethods[] = {
    {"files.list", Needs::Plc, list},     {"files.read", Needs::Plc, read},
    {"files.write", Needs::Plc, write},   {"files.create", Needs::Plc, create},
    {"files.delete", Needs::Plc, remove}, {"files.rename", Needs::Plc, rename},
};

}  // namespace
}  // namespace file_methods

std::span<const Method> fileMethods() { return file_methods::kMethods; }

}  // namespace merker::workbench
