// The hardware as the project would have it: a text of merker.toml, changed as the hardware view
// asks, with what comes of it. Nothing is written here.
#pragma once

#include "project/settings_edit.h"
#include "source/symbol_table.h"
#include "workbench/fields.h"
#include "workbench/json.h"

namespace merker::workbench {

// One change of a request; wrong fields are problems in `change`.
void applyChange(project::SettingsEdit& edit, const Fields& change);
// Problems that this change brought and that forbid it: a module without a place, a value that is
// not possible. What only the whole shows (gaps, a missing interface module) stays allowed.
Problems reasonsAgainst(const project::SettingsEdit& before, const project::SettingsEdit& after,
                        const Fields& change);

// {racks, cpu, problems, current, limit}
Json planRows(const project::SettingsEdit& edit, const source::SymbolTable& symbols);
// {types: [{order, name, text, kind, slots, ...}]}: what can be placed where.
Json catalogueRows();

}  // namespace merker::workbench
