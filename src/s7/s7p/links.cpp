#include "s7p/links.h"

#include <algorithm>
#include <array>

namespace merker::s7p {
namespace {

constexpr std::size_t kPage = 512, kPageHeader = 16, kEntry = 24;
// Types of targets and relations.
constexpr std::uint32_t kBlocks = 0x116001, kHasBlocks = 30;
constexpr std::uint32_t kSymbols = 0x113001, kHasSymbols = 24;
constexpr std::uint32_t kSources = 0x112004, kHasSources = 98;
constexpr std::uint32_t kInModule = 17;

std::uint32_t little(const std::uint8_t* from) {
  return from[0] | from[1] << 8u | from[2] << 16u | std::uint32_t{from[3]} << 24u;
}

void take(const std::uint8_t* entry, Links& links) {
  const std::uint32_t type = little(entry + 8), id = little(entry + 12);
  const std::uint32_t relation = little(entry + 16);
  if (type == kBlocks && relation == kHasBlocks) links.blocks = id;
  if (type == kSymbols && relation == kHasSymbols) links.symbols = id;
  if (type == kSources && relation == kHasSources) links.sources = id;
  if (relation != kInModule) return;
  links.moduleType = type;
  links.module = id;
}

}  // namespace

std::optional<Links> readLinks(const archive::File& file, std::uint32_t offset) {
  std::array<std::uint8_t, kPage> page{};
  const std::size_t got = file.read(offset, page);
  if (offset < kPage || got < kPageHeader || little(page.data()) != offset ||
      little(page.data() + 4) != 0)
    return std::nullopt;
  const std::size_t count =
      std::min<std::size_t>(little(page.data() + 8), (got - kPageHeader) / kEntry);
  Links links;
  for (std::size_t i = 0; i < count; ++i) take(page.data() + kPageHeader + i * kEntry, links);
  return links;
}

}  // namespace merker::s7p
