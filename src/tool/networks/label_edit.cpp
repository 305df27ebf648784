// The label at the beginning of a network.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "networks/source_edit.h"
#include "networks/text.h"
#include "step7/cursor.h"

namespace merker::networks {

bool isLabel(std::string_view text) {
  constexpr std::size_t kLongest = 4;  // characters
  return !text.empty() && characterCount(text) <= kLongest && step7::isWordStart(text.front()) &&
         std::all_of(text.begin(), text.end(), step7::isWordChar);
}

namespace {

bool isTaken(const Block& block, const std::string& label) {
  for (const Network& network : block.networks) {
    if (network.source.label == label) return true;
    for (const graph::Written& place : network.source.places)
      if (place.label == label) return true;
  }
  return false;
}

// Without a statement it stands alone on its line, and waits.
TextEdit waiting(const graph::SourceNetwork& source, std::size_t network,
                 const std::string& label) {
  TextEdit out;
  out.network = network;
  out.from = source.labelLine > 0 ? source.labelLine : source.code;
  out.to = source.labelLine > 0 ? out.from + 1 : out.from;
  if (!label.empty()) out.lines.push_back(label + ":");
  return out;
}

}  // namespace

Edited changeLabel(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                   const std::string& label, const Surroundings& around) {
  const auto found = findBlock(file, line, around);
  const Network* at = networkOf(found, network);
  if (at == nullptr) return Refusal{};
  const graph::SourceNetwork& source = at->source;
  if (around.language != source::Language::Step7) return Refusal{Obstacle::Label};
  TextEdit out;
  out.network = network;
  out.from = out.to = source.places.empty() ? source.code : source.places.front().line;
  const bool waits = source.places.empty();
  if (label == (waits ? source.label : source.places.front().label)) return out;
  if (!label.empty() && (!isLabel(label) || isTaken(found->block, label)))
    return Refusal{Obstacle::Label};
  if (waits) return waiting(source, network, label);
  const graph::Written& first = source.places.front();
  // From the beginning of the label's line to the end of that of the statement's first word.
  const std::uint32_t last = file.position(first.begin).line;
  const auto start = [&](std::uint32_t number) {
    return static_cast<std::size_t>(file.line(number).data() - file.text().data());
  };
  const std::string_view before =
      file.text().substr(start(first.line), first.start - start(first.line));
  const std::string_view rest = file.line(last).substr(first.begin - start(last));
  const std::size_t width = first.begin - start(last) - (last == first.line ? before.size() : 0);
  const bool indented = trim(before).empty() && last == first.line;
  const std::size_t column = indented ? width + before.size() : width;
  const std::string mark = label.empty() ? std::string() : label + ": ";
  out.to = last + 1;
  out.lines.push_back(
      fmt::format("{}{:<{}}{}", indented ? std::string_view() : before, mark, column, rest));
  return out;
}

}  // namespace merker::networks
