// Elements and networks that go to another place of their block.
#include "networks/whole_edit.h"

namespace merker::networks {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + '\n';
  return out;
}

// What is there is taken out by one edit, and comes to its new place by another.
Edited moved(const source::SourceFile& file, const Edited& taken, std::uint32_t line,
             std::size_t network, const graph::Edit& place, const std::vector<std::string>& lines,
             const Surroundings& around) {
  if (!taken) return taken.error();
  const source::SourceFile without(file.name(), applied(file, *taken));
  const Edited put = paste(without, line, network, place, joined(lines), around);
  if (!put) return put.error();
  TextEdit out = difference(file, source::SourceFile(file.name(), applied(without, *put)));
  out.network = put->network;
  out.select = put->select;
  return out;
}

Edited moveNetwork(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                   const graph::Edit& place, std::size_t from, const Surroundings& around) {
  if (from == network) {
    TextEdit none;
    none.network = network;
    return none;
  }
  const auto lines = copy(file, line, from, {}, around);
  if (!lines) return lines.error();
  graph::Edit beside = place;
  beside.at = {};
  return moved(file, removeNetwork(file, line, from, around), line,
               from < network ? network - 1 : network, beside, *lines, around);
}

}  // namespace

Edited move(const source::SourceFile& file, std::uint32_t line, std::size_t network,
            const graph::Edit& place, const Origin& from, const Surroundings& around) {
  if (from.element.node < 0) return moveNetwork(file, line, network, place, from.network, around);
  graph::Edit edit = place;
  edit.action = graph::Action::Move;
  edit.from = from.element;
  if (from.network == network) return networks::edit(file, line, network, edit, around);
  const auto found = findBlock(file, line, around);
  const Network* source = networkOf(found, from.network);
  if (source == nullptr) return Refusal{};
  if (source->tree && graph::carriesBranch(*source->tree, from.element))
    return Refusal{Obstacle::Tree, graph::EditProblem::WithBranch};
  const auto lines = copy(file, line, from.network, {from.element}, around);
  if (!lines) return lines.error();
  graph::Edit taken;
  taken.action = graph::Action::Delete;
  taken.ladder = place.ladder;
  taken.at = {from.element.node, graph::kNoPin, from.element.first};
  return moved(file, networks::edit(file, line, from.network, taken, around), line, network, place,
               *lines, around);
}

}  // namespace merker::networks
