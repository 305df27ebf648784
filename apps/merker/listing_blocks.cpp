#include "listing_blocks.h"

#include <fmt/format.h>

#include <iostream>

#include "control/cnc.h"
#include "control/memory.h"
#include "mc5/disassembly.h"
#include "monitor/block_list.h"
#include "step5/compiler.h"

namespace merker::app {
namespace {

constexpr unsigned kProgramSegment = 5, kDataSegment = 6;

bool isData(const mc5::Block& block) { return block.id.type == mc5::BlockType::Db; }

std::string hex(std::span<const std::uint16_t> code) {
  std::string text;
  for (const std::uint16_t word : code)
    text += fmt::format("{}{:04X}", text.empty() ? "" : " ", word);
  return text;
}

void printCode(const mc5::Program& program, const mc5::Block& block) {
  if (isData(block))
    for (std::size_t i = 0; i < block.words.size(); ++i)
      std::cout << fmt::format("  {:04X}: {:04X}\n", i, block.words[i]);
  else
    for (const mc5::Line& line : step5::disassemble(program, block))
      std::cout << "  " << mc5::toString(line) << '\n';
}

// Where the programmer's block directory shows each block (9.1.2, S5-MEM-07); without those that
// found no room.
std::map<mc5::BlockId, std::uint32_t> addresses(const Build& build) {
  cnc::Cnc control(build.controlOptions());
  std::map<mc5::BlockId, std::uint32_t> result;
  for (const sinumerik::DirectoryEntry& entry : control.plc().programmer().directory())
    result[entry.id] = entry.address;
  return result;
}

void printUse(unsigned segment, std::string_view what, const cnc::SegmentUse& use) {
  std::cout << fmt::format("segment {} ({}): {} of {} words used, {} free\n", segment, what,
                           use.used, use.size, use.size - use.used);
}

nlohmann::json useToJson(unsigned segment, const cnc::SegmentUse& use) {
  return {{"segment", segment}, {"used", use.used}, {"words", use.size}};
}

nlohmann::json codeToJson(const mc5::Program& program, const mc5::Block& block) {
  nlohmann::json lines = nlohmann::json::array();
  for (const mc5::Line& line : step5::disassemble(program, block))
    lines.push_back({{"offset", line.offset}, {"words", hex(line.words)}, {"text", line.text}});
  return lines;
}

std::string listingOf(const Build& build, const ListingOptions& options) {
  return step5::listing(build.listings, options.symbols ? &build.project.symbols : nullptr);
}

}  // namespace

// Lengths as the block directory of the programmer shows them: with the header (S5-BLK-08).
void printListings(const Build& build, const ListingOptions& options) {
  if (options.text) {
    std::cout << listingOf(build, options);
    return;
  }
  std::cout << fmt::format("{:<10} {:<10} {:>6} {:>6} {:>8}\n", "block", "name", "BIB", "words",
                           "address");
  const auto at = addresses(build);
  for (const auto& [id, block] : build.listings) {
    const std::string address = at.contains(id) ? fmt::format("{:04X}", at.at(id)) : "-";
    const monitor::BlockRow row = monitor::blockRow(block);
    std::cout << fmt::format("{:<10} {:<10} {:>6} {:>6} {:>8}\n", toString(row.id), row.symbol,
                             row.library == 0 ? "" : std::to_string(row.library), row.load,
                             address);
    if (options.code) printCode(build.listings, block);
  }
  const cnc::MemoryUse use = cnc::memoryUse(build.controlOptions());
  printUse(kProgramSegment, "user program", use.program);
  printUse(kDataSegment, "user data", use.data);
}

nlohmann::json listingsToJson(const Build& build, const ListingOptions& options) {
  nlohmann::json blocks = nlohmann::json::array();
  const auto at = addresses(build);
  for (const auto& [id, block] : build.listings) {
    const monitor::BlockRow row = monitor::blockRow(block);
    nlohmann::json entry = {{"block", toString(row.id)},
                            {"name", row.symbol},
                            {"library", row.library},
                            {"words", row.load}};
    if (at.contains(id)) entry["address"] = fmt::format("{:04X}", at.at(id));
    if (options.code)
      entry["code"] =
          isData(block) ? nlohmann::json(hex(block.words)) : codeToJson(build.listings, block);
    blocks.push_back(std::move(entry));
  }
  const cnc::MemoryUse use = cnc::memoryUse(build.controlOptions());
  nlohmann::json document = {
      {"blocks", blocks},
      {"memory", {useToJson(kProgramSegment, use.program), useToJson(kDataSegment, use.data)}},
      {"problems", toJson(build.problems)}};
  if (options.text) document["listing"] = listingOf(build, options);
  return document;
}

}  // namespace merker::app
