// The merker.toml of several stations while it is changed.
#pragma once

#include <optional>
#include <string>

#include "project/project.h"
#include "project/settings_edit.h"
#include "workbench/project_folder.h"

namespace merker::workbench {

constexpr const char* kNetworkFile = "merker.toml";

// TOML of a text; names and operands have no control characters that would need more.
std::string tomlText(std::string_view text);
std::optional<Problem> firstError(const Problems& problems);

class NetworkFile {
 public:
  // `path`: of the project.
  explicit NetworkFile(const std::string& path);

  std::optional<Problem> problem() const;
  const std::string& text() const { return read_->text; }
  project::SettingsEdit edit() const;
  // The project as it would be with this text.
  project::Project with(const std::string& text) const;
  // An error that this text has, with those of its stations, and the file did not have.
  std::optional<Problem> freshError(const std::string& text) const;
  std::optional<Problem> write(const std::string& text) const;
  const ProjectFolder& folder() const { return folder_; }

 private:
  ProjectFolder folder_;
  Result<ProjectFolder::Content> read_;
};

}  // namespace merker::workbench
