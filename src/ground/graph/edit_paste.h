// Elements that are copied, and those of a network or of another place that are put in.
#pragma once

#include <optional>
#include <span>

#include "graph/edit_insert.h"

namespace merker::graph {

// The elements in the order in which they stand, each as if it stood alone: a box without what
// comes to it, a coil without its rung. Nothing if one of them is not found.
std::optional<Network> copied(const Network& network, std::span<const Selection> elements,
                              const Rules& rules, std::uint32_t firstWire);

// `edit.pasted`: elements and coils alone go where `insert` puts them, rungs below the one of the
// place.
std::optional<EditProblem> paste(const Editing& editing, const std::optional<Location>& at);
// The element `edit.from`, which goes to `edit.at`.
std::optional<EditProblem> move(const Editing& editing);

}  // namespace merker::graph
