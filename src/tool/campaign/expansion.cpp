#include "campaign/expansion.h"

#include <fmt/format.h>

#include <charconv>

#include "campaign/draw.h"

namespace merker::campaign {

Choice choiceAt(const Definition& definition, std::uint64_t number) {
  Choice choice{number, 0, std::vector<Value>(definition.parameters.size())};
  if (definition.repeat > 0) {
    choice.seed = definition.firstSeed + number % definition.repeat;
    number /= definition.repeat;
  }
  for (std::size_t i = definition.parameters.size(); i > 0; --i) {
    const Parameter& parameter = definition.parameters[i - 1];
    if (parameter.draw) {
      choice.values[i - 1] = valueOf(drawn(*parameter.draw, choice.seed, parameter.name));
      continue;
    }
    choice.values[i - 1] = parameter.values[number % parameter.values.size()].value;
    number /= parameter.values.size();
  }
  return choice;
}

std::string describe(const Definition& definition, const Choice& choice) {
  std::string text;
  const auto add = [&](std::string_view name, std::string_view value) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", name, value);
  };
  for (std::size_t i = 0; i < choice.values.size(); ++i)
    add(definition.parameters[i].name, choice.values[i].text);
  if (definition.repeat > 0) add("seed", fmt::format("{}", choice.seed));
  return text.empty() ? "one run" : text;
}

std::optional<Shard> parseShard(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.number);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, shard.count);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  const bool possible =
      shard.number >= 1 && shard.number <= shard.count && shard.count <= kMostRuns;
  return possible ? std::optional(shard) : std::nullopt;
}

}  // namespace merker::campaign
