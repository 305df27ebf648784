// Networks that come and go, and what is written above them.
#include "networks/whole_edit.h"

namespace merker::networks {
namespace {

bool isOneLine(std::string_view text) {
  return text.find_first_of("\r\n\f\v") == std::string::npos;
}

bool isGood(const Heading& heading) {
  for (const std::string& line : heading.comment)
    if (!isOneLine(line) || line.starts_with('=')) return false;  // "//=" is a check
  return isOneLine(heading.title);
}

}  // namespace

Edited insertNetwork(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                     bool before, const Heading& heading, const Surroundings& around) {
  const auto found = findBlock(file, line, around);
  const Network* at = networkOf(found, network);
  if (at == nullptr) return Refusal{};
  if (!isGood(heading)) return Refusal{Obstacle::Text};
  TextEdit out;
  const bool replaces = isReplaced(at->source);
  out.network = before || replaces ? network : network + 1;
  out.lines = found->text->heading(out.network, heading);
  if (before) {
    // Code without a head would belong to the new network.
    if (!at->source.headed && !replaces)
      for (std::string& own : found->text->heading(network + 1, {})) out.lines.push_back(own);
    out.from = out.to = at->source.line;
  } else {
    out.from = out.to = behindNetwork(file, at->source);
  }
  return withNumbers(file, *found, std::move(out), around);
}

Edited removeNetwork(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                     const Surroundings& around) {
  const auto found = findBlock(file, line, around);
  const Network* at = networkOf(found, network);
  if (at == nullptr) return Refusal{};
  TextEdit out;
  out.from = at->source.line;
  out.to = at->source.end;
  out.network = network < found->block.networks.size() ? network : network - 1;
  if (found->block.networks.size() == 1) out.network = 1;
  return withNumbers(file, *found, std::move(out), around);
}

Edited changeHeading(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                     const Heading& heading, const Surroundings& around) {
  const auto found = findBlock(file, line, around);
  const Network* at = networkOf(found, network);
  if (at == nullptr) return Refusal{};
  if (!isGood(heading)) return Refusal{Obstacle::Text};
  TextEdit out;
  out.lines = found->text->heading(network, heading);
  out.from = at->source.line;
  out.to = at->source.headed ? at->source.code : at->source.line;
  out.network = network;
  return out;
}

}  // namespace merker::networks
