// The hardware as the project would have it: a text of merker.toml, changed as the hardware view
// asks, with what comes of it. Nothing is written here.
#pragma once

#include "project/project.h"
#include "project/settings_edit.h"
#include "source/symbol_table.h"
#include "workbench/fields.h"
#include "workbench/json.h"
#include "workbench/project_folder.h"

namespace merker::workbench {

// Bytes of a merker.toml that is changed here. A station has 44 slots; 20 kB are a long one.
constexpr std::size_t kLongestSettings = 128 << 10;

// One change of a request; wrong fields are problems in `change`.
void applyChange(project::SettingsEdit& edit, const Fields& change);
// What a text of merker.toml makes of the station; it is read once.
struct Plan {
  project::Project project;
  Problems problems;  // sorted

  // Files that it names lie in the folder.
  static Plan of(const project::SettingsEdit& edit, const ProjectFolder& folder);
};

// Problems that this change brought and that forbid it: a module without a place, a value that is
// not possible. What only the whole shows (gaps, a missing interface module) stays allowed.
Problems reasonsAgainst(const Plan& before, const Plan& after, const Fields& change);

// {racks, cpu, problems, current, limit}
Json planRows(const Plan& plan, const project::SettingsEdit& edit,
              const source::SymbolTable& symbols);
// {types: [{order, name, text, kind, slots, ...}]}: what can be placed where.
Json catalogueRows();

}  // namespace merker::workbench
