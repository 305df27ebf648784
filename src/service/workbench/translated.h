// Blocks that are translated for the CPU before it gets them, by the thread that compiles.
#pragma once

#include "station/translations.h"
#include "workbench/elsewhere.h"

namespace merker::workbench {

// `then` when the next download, or take(), of this program needs no translation.
Answer supplied(const Call& call, ProgramRef program, std::function<Answer(const Call&)> then);

// The blocks of the CPU for another engine; `then` when they are there and it still has them.
using Translations = std::shared_ptr<station::Translations>;
Answer translatedFor(const Call& call, station::Engine engine,
                     std::function<Answer(const Call&, const station::Translations&)> then);

}  // namespace merker::workbench
