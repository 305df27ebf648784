#include "networks/free_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/text.h"

namespace merker::networks {
namespace {

constexpr std::size_t kLongestLabel = 4;  // characters

using Renames = std::map<std::string, std::string, std::less<>>;

// M001 becomes M002, LOOP becomes LOO1: the same begin, the next number that is free.
std::string nextLabel(const std::string& label, const std::set<std::string>& taken) {
  std::size_t begin = label.size();
  while (begin > 0 && label[begin - 1] >= '0' && label[begin - 1] <= '9') --begin;
  const std::size_t width = std::max<std::size_t>(label.size() - begin, 1);
  for (int number = 1;; ++number) {
    const std::string digits = fmt::format("{:0{}}", number, width);
    std::string name = label.substr(0, begin);
    while (!name.empty() && characterCount(name) + digits.size() > kLongestLabel) {
      while ((name.back() & 0xC0) == 0x80) name.pop_back();  // the rest of a character
      name.pop_back();
    }
    name += digits;
    if (!taken.contains(name)) return name;
  }
}

bool isOneOf(std::size_t i, std::size_t from, std::size_t to) { return i >= from && i < to; }

Renames renames(const Block& block, std::size_t from, std::size_t to) {
  std::set<std::string> all, others;
  for (std::size_t i = 0; i < block.networks.size(); ++i)
    for (const graph::Written& place : block.networks[i].source.places) {
      all.insert(place.label);
      if (!isOneOf(i, from, to)) others.insert(place.label);
    }
  Renames out;
  for (std::size_t i = from; i < to; ++i)
    for (const graph::Written& place : block.networks[i].source.places) {
      if (place.label.empty() || !others.contains(place.label) || out.contains(place.label))
        continue;
      out[place.label] = nextLabel(place.label, all);
      all.insert(out[place.label]);
    }
  return out;
}

}  // namespace

std::string withFreeLabels(const source::SourceFile& file, const Block& block, std::size_t from,
                           std::size_t to) {
  const Renames renamed = renames(block, from, to);
  std::string text;
  std::size_t copied = 0;  // bytes
  const auto replace = [&](std::size_t at, const std::string& label) {
    const auto row = renamed.find(label);
    if (row == renamed.end() || at < copied || file.text().substr(at, label.size()) != label)
      return;
    text += file.text().substr(copied, at - copied);
    text += row->second;
    copied = at + label.size();
  };
  for (std::size_t i = from; i < to; ++i) {
    const graph::SourceNetwork& source = block.networks[i].source;
    for (std::size_t n = 0; n < source.places.size(); ++n) {
      replace(source.places[n].start, source.places[n].label);
      if (isJump(source.statements[n].op))
        replace(source.places[n].operand, source.statements[n].operand.text);
    }
  }
  text += file.text().substr(copied);
  return text;
}

}  // namespace merker::networks
