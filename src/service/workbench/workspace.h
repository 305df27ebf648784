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
  // `given`: the project of the command line, which may lie anywhere.
  Workspace(std::string folder, std::string examples, std::string given)
      : folder_(std::move(folder)), examples_(std::move(examples)), given_(std::move(given)) {}

  const std::string& folder() const { return folder_; }
  std::vector<Example> examples() const;
  static std::span<const Template> templates();

  // The copy of an example in the workspace, made at the first time.
  Result<std::string> copyExample(const std::string& id) const;
  // A folder of a project that may be opened: P1318 for others.
  Result<std::string> folderToOpen(const std::string& folder) const;
  // A new folder for a project: P1317, P1312.
  Result<std::string> makeFolder(const std::string& name) const;
  // A name like this one that a new project can have.
  std::string freeName(std::string_view wanted) const;
  // The folder of a project that has just been made.
  Result<std::string> make(const NewProject& wanted) const;

 private:
  std::string folder_, examples_, given_;
};

}  // namespace merker::workbench
