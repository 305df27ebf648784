#include "networks/whole_edit.h"

#include <algorithm>

#include "base/text.h"

namespace merker::networks {
namespace {

bool areInOrder(const source::SourceFile& file, const Found& found) {
  return std::all_of(found.block.networks.begin(), found.block.networks.end(),
                     [&](const Network& network) {
                       if (!network.source.headed) return true;
                       const std::string_view head = file.line(network.source.line);
                       return found.text->numbered(head, network.number) == head;
                     });
}

}  // namespace

TextEdit difference(const source::SourceFile& before, const source::SourceFile& after) {
  TextEdit out;
  std::uint32_t end = after.lineCount() + 1;
  out.to = before.lineCount() + 1;
  while (out.from < std::min(out.to, end) && before.line(out.from) == after.line(out.from))
    ++out.from;
  while (out.to > out.from && end > out.from && before.line(out.to - 1) == after.line(end - 1)) {
    --out.to;
    --end;
  }
  for (std::uint32_t line = out.from; line < end; ++line) out.lines.emplace_back(after.line(line));
  return out;
}

TextEdit withNumbers(const source::SourceFile& file, const Found& found, TextEdit edit,
                     const Surroundings& around) {
  if (around.language == source::Language::Step7 || !areInOrder(file, found)) return edit;
  const source::SourceFile after(file.name(), applied(file, edit));
  const auto now = findBlock(after, found.block.line, around);
  if (!now || areInOrder(after, *now)) return edit;
  std::string text;
  std::size_t copied = 0;  // bytes
  for (const Network& network : now->block.networks) {
    if (!network.source.headed) continue;
    const std::string_view head = after.line(network.source.line);
    const auto begin = static_cast<std::size_t>(head.data() - after.text().data());
    text += after.text().substr(copied, begin - copied);
    text += now->text->numbered(head, network.number);
    copied = begin + head.size();
  }
  text += after.text().substr(copied);
  TextEdit out = difference(file, source::SourceFile(file.name(), std::move(text)));
  out.network = edit.network;
  out.select = edit.select;
  return out;
}

std::uint32_t behindNetwork(const source::SourceFile& file, const graph::SourceNetwork& network) {
  std::uint32_t end = network.end;
  while (end > network.code && trim(file.line(end - 1)).empty()) --end;
  return end;
}

}  // namespace merker::networks
