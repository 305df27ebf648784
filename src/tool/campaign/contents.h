// What the id of a run stands for, but for its own values: a change of it gives other ids.
#pragma once

#include "campaign/definition.h"
#include "campaign/digest.h"
#include "compilation/build.h"

namespace merker::campaign {

// Every file that the project was made of, by its name below the project folder.
void addProject(const compilation::Build& build, Digest& digest);
// Times, the scenario and measures; not where it stands, not what only limits a run.
void addDefinition(const Definition& definition, Digest& digest);

}  // namespace merker::campaign
