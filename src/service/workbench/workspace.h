// Where projects are: the user's folder, and the examples that are copied into it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "address/area.h"
#include "base/result.h"

namespace merker::workbench {

struct Example {
  std::string id;  // path below the folder of examples
  std::string title, description;
  bool copied = false;  // into the workspace
};

struct Template {
  std::string_view id, title;
};

// What the wizard asks (S7-MGR-01).
struct NewProject {
  std::string name, model, form;  // form: of a template
  Mnemonics mnemonics = Mnemonics::German;
  std::uint32_t ob = 1, mpiAddress = 2;
};

class Workspace {
 public:
  Workspace() = default;
  // `given`: the project of the command line, which may lie anywhere. The folder may be relative or
  // a link: what is in it has one absolute path, which opens it again.
  Workspace(const std::string& folder, std::string examples, std::string given);

  const std::string& folder() const { return folder_; }
  const std::string& given() const { return given_; }
  std::vector<Example> examples() const;
  // Folders of projects below that of the workspace, relative to it.
  std::vector<std::string> projects() const;
  static std::span<const Template> templates();

  // The copy of an example in the workspace, made at the first time; `fresh`: one more. `german`:
  // with German words where the example has them.
  Result<std::string> copyExample(const std::string& id, bool fresh = false,
                                  bool german = false) const;
  // A folder of a project that may be opened: P1318 for others.
  Result<std::string> folderToOpen(const std::string& folder) const;
  // Each folder once, those of the workspace by the path that opens them.
  std::vector<std::string> named(const std::vector<std::string>& folders) const;
  // A new folder for a project: P1317, P1312.
  Result<std::string> makeFolder(const std::string& name) const;
  // A name like this one that a new project can have.
  std::string freeName(std::string_view wanted) const;
  // What is wrong with this wish apart from its name; and its files, into a folder that is empty.
  static std::optional<Problem> wrong(const NewProject& wanted);
  static std::optional<Problem> fill(const std::string& folder, const NewProject& wanted);
  // The folder of a project that has just been made.
  Result<std::string> make(const NewProject& wanted) const;

 private:
  std::string folder_, examples_, given_;
};

}  // namespace merker::workbench
