// Import of what a browser sends: first its files, then what is in them, then the import.
#include "base/code_page.h"
#include "workbench/base64.h"
#include "workbench/import_task.h"

namespace merker::workbench {
namespace import_methods {
namespace {

Answer refusedImport(std::string_view why) {
  return refused(ProblemCode::P1308, "the import", why);
}

// One at a time: what is sent lies on the disk of this computer.
Answer begin(const Call& call) {
  Shared& shared = call.shared;
  if (!shared.upload.expired() && shared.uploadOwner != call.id)
    return refusedImport("another browser is importing");
  shared.discard(std::exchange(call.browser.upload, nullptr));
  call.browser.upload = Upload::make();
  if (!call.browser.upload) return refusedImport("there is no temporary folder");
  shared.upload = call.browser.upload;
  shared.uploadOwner = call.id;
  return empty();
}

// Null: there is nothing that something could be added to, or that could be imported.
std::optional<Answer> missing(const Call& call) {
  if (!call.browser.upload) return refusedImport("import.begin comes first");
  if (call.browser.upload->used()) return refusedImport("it is running");
  return std::nullopt;
}

constexpr std::size_t kMostParts = 1000;

Answer addParts(const Aside& aside, Upload& upload) {
  for (const Fields& part : aside.fields.objects("files", kMostParts)) {
    const std::string path = part.text("path"), data = part.text("data");
    if (!aside.fields.good()) return aside.wrong();
    const auto bytes = fromBase64(data);
    if (!bytes) return refused(ProblemCode::P1305, "data", "base64");
    if (auto problem = upload.add(path, *bytes)) return one(*problem);
  }
  return aside.fields.good() ? empty() : Answer(aside.wrong());
}

// Without an upload the fields are checked all the same.
Answer add(const Call& call) {
  const auto why = missing(call);
  return elsewhere(call, call.shared.clerk,
                   [why, upload = call.browser.upload](const Aside& aside) -> Answer {
                     if (!why) return addParts(aside, *upload);
                     for (const Fields& part : aside.fields.objects("files", kMostParts))
                       part.text("path"), part.text("data");
                     return aside.fields.good() ? *why : Answer(aside.wrong());
                   });
}

std::optional<OpenProject> openProject(const Call& call) {
  if (!call.shared.plc) return std::nullopt;
  const compilation::Build& build = call.plc().build();
  return OpenProject{build.project.path, std::string(build.project.model->keyword),
                     build.isListing(), call.shared.folder.growing()};
}

// The answer waits for a task that import.cancel ends.
Answer cancellable(const Call& call, Answer answer) {
  if (answer.waits()) call.browser.importing = answer.waits()->task;
  return answer;
}

Answer look(const Call& call) {
  if (const auto why = missing(call)) return *why;
  const auto use = std::make_shared<Upload::Use>(call.browser.upload);
  return cancellable(call, elsewhere(call, call.shared.helper,
                                     [use, workspace = call.shared.workspace,
                                      open = openProject(call)](const Aside& aside) {
                                       return lookAt(**use, workspace, open, aside.stop);
                                     }));
}

struct Imported {
  Answer answer;
  Listing files;  // of the open project, if they went there
};

Imported imported(const Aside& aside, const Upload& upload, const Workspace& workspace,
                  const ImportWish& wish) {
  if (!wish.name.empty())
    return {written(importNew(upload, workspace, wish, aside.stop), aside.folder), {}};
  Answer answer = written(importInto(upload, aside.folder, wish, aside.stop), aside.folder);
  return {std::move(answer), aside.folder.list()};
}

// 0: as the source says.
unsigned pageOf(const Fields& fields) {
  const std::size_t chosen =
      fields.choice("codePage",
                    {"", "437", "850", "852", "866", "932", "936", "949", "950", "1250", "1251",
                     "1252", "1253", "1254", "1255", "1256", "1257", "20866"},
                    0);
  static_assert(std::size(kCodePages) == 17);  // these
  return chosen == 0 ? 0 : kCodePages[chosen - 1];
}

Answer run(const Call& call) {
  ImportWish wish;
  wish.name = call.fields.text("name", "");
  wish.program = call.fields.text("program", "");
  wish.page = pageOf(call.fields);
  if (!call.fields.good()) return call.fields.problems();
  if (const auto why = missing(call)) return *why;
  if (wish.name.empty() && !call.shared.plc) return refused(ProblemCode::P1315);
  if (wish.name.empty() && !call.shared.folder.growing())
    return refusedImport("the open project is a single file; choose a new project");
  wish.open = openProject(call).value_or(OpenProject{});
  const std::uint64_t look = call.shared.nextLook(), shown = call.shared.shown;
  Answer answer = cancellable(
      call, elsewhere<Imported>(
                call, call.shared.helper,
                [use = std::make_shared<Upload::Use>(call.browser.upload),
                 workspace = call.shared.workspace,
                 wish](const Aside& aside) { return imported(aside, **use, workspace, wish); },
                [look, shown, into = wish.name.empty()](const Call& now, Imported& made) {
                  if (into && now.shared.shown == shown)
                    now.shared.take(look, std::move(made.files));
                  // Refused: it can be tried once more, under another name.
                  if (made.answer) now.shared.discard(std::exchange(now.browser.upload, nullptr));
                  return std::move(made.answer);
                }));
  // Who follows the folder would compile again and again what is not complete yet.
  if (wish.name.empty()) call.shared.adding = call.browser.importing;
  return answer;
}

// What has been sent is deleted; an import that is running ends, and leaves nothing behind.
Answer cancel(const Call& call) {
  if (const Work task = std::exchange(call.browser.importing, nullptr)) task->cancel();
  call.shared.discard(std::exchange(call.browser.upload, nullptr));
  return empty();
}

constexpr Method kMethods[] = {
    {"import.begin", Needs::Nothing, begin},
    {"import.add", Needs::Nothing, add},
    {"import.look", Needs::Nothing, look, Kind::Compiles},
    {"import.run", Needs::Nothing, run, Kind::Compiles},
    {"import.cancel", Needs::Nothing, cancel},
};

}  // namespace
}  // namespace import_methods

std::span<const Method> importMethods() { return import_methods::kMethods; }

}  // namespace merker::workbench
