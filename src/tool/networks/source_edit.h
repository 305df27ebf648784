// What an edit of a network makes of its text.
#pragma once

#include "graph/edit.h"
#include "graph/language.h"
#include "networks/source_networks.h"

namespace merker::networks {

// Lines [from, to) of the text become `lines`; from == to: inserted before that line.
struct TextEdit {
  std::uint32_t from = 1, to = 1;
  std::vector<std::string> lines;
  std::size_t network = 1;       // number of the network to select
  graph::Selection select = {};  // and the element in it
  bool operator==(const TextEdit&) const = default;
};

enum class Obstacle : std::uint8_t { NoNetwork, Awl, Text, Label, Clipboard, Tree };

struct Refusal {
  Obstacle obstacle = Obstacle::NoNetwork;
  graph::EditProblem problem = graph::EditProblem::NoNode;  // Obstacle::Tree
};

std::string_view text(const Refusal& refusal, graph::Language language);

using Edited = Result<TextEdit, Refusal>;

// Of operands only their texts are looked at; a CALL box without arguments gets the parameters of
// its block. `line`: any of the block. What does not change keeps its lines with their comments.
Edited edit(const source::SourceFile& file, std::uint32_t line, std::size_t network,
            const graph::Edit& edit, const Surroundings& around);

// Title and comment of a network.
struct Heading {
  std::string title;
  std::vector<std::string> comment;
};

Edited insertNetwork(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                     bool before, const Heading& heading, const Surroundings& around);
Edited removeNetwork(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                     const Surroundings& around);
Edited changeHeading(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                     const Heading& heading, const Surroundings& around);

// What jumps of STEP 7 lead to; empty: none. Jumps that name the old one are not changed.
Edited changeLabel(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                   const std::string& label, const Surroundings& around);

// Elements of a network as lines of AWL, each without what comes to it; with none the whole network
// with its title and comment.
Result<std::vector<std::string>, Refusal> copy(const source::SourceFile& file, std::uint32_t line,
                                               std::size_t network,
                                               const std::vector<graph::Selection>& elements,
                                               const Surroundings& around);

// Lines of AWL: elements go to `place.place` of `place.at`, as new ones do; whole networks come
// before or behind the network, with labels that are free in the block.
Edited paste(const source::SourceFile& file, std::uint32_t line, std::size_t network,
             const graph::Edit& place, std::string_view lines, const Surroundings& around);

// What is moved: an element, or a whole network.
struct Origin {
  std::size_t network = 1;
  graph::Selection element = {};  // node -1: the network
};
Edited move(const source::SourceFile& file, std::uint32_t line, std::size_t network,
            const graph::Edit& place, const Origin& from, const Surroundings& around);

// The text with the edit done.
std::string applied(const source::SourceFile& file, const TextEdit& edit);

}  // namespace merker::networks
