#include "case.h"

#include <fmt/format.h>

#include <sstream>

#include "mc7/listing.h"

namespace merker::differential {
namespace {

std::string hex(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += fmt::format(" {:02X}", byte);
  return text;
}

std::optional<BlockKind> kindOf(const std::string& name) {
  for (const BlockKind kind : {BlockKind::OB, BlockKind::FC, BlockKind::FB})
    if (toString(BlockId{kind, 1}).substr(0, 2) == name) return kind;
  return std::nullopt;
}

}  // namespace

std::string toText(const Case& c) {
  std::string text = fmt::format("model {}\nseed {}\n", c.model, c.seed);
  for (const auto& [id, code] : c.blocks) text += fmt::format("{} ={}\n", toString(id), hex(code));
  return text;
}

std::optional<Case> fromText(const std::string& text) {
  Case c;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (first.empty() || first[0] == '#') continue;
    if (first == "model") {
      std::getline(words >> std::ws, c.model);
    } else if (first == "seed") {
      words >> c.seed;
    } else {
      const auto kind = kindOf(first);
      std::uint16_t number = 0;
      char equals = 0;
      if (!kind || !(words >> number >> equals)) return std::nullopt;
      std::vector<std::uint8_t>& code = c.blocks[{*kind, number}];
      for (unsigned byte = 0; words >> std::hex >> byte;)
        code.push_back(static_cast<std::uint8_t>(byte));
    }
  }
  return c;
}

std::string listing(const Case& c) {
  std::string text;
  for (const auto& [id, code] : c.blocks) {
    text += fmt::format("{}\n", toString(id));
    for (const mc7::Place& place : mc7::list(code).places)
      text += fmt::format("  {:4}  {}\n", place.offset,
                          place.known ? mc7::text(place.instruction, Mnemonics::German) : "?");
  }
  return text;
}

}  // namespace merker::differential
