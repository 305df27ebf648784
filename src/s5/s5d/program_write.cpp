#include <algorithm>

#include "s5d/block_bytes.h"
#include "s5d/bytes.h"
#include "s5d/comments.h"
#include "s5d/pre_header.h"
#include "s5d/program.h"
#include "source/dos_text.h"

namespace merker::s5d {
namespace {

using Block = std::vector<std::uint8_t>;

// Pre-header, block, comments.
std::vector<Block> blocksOf(const mc5::Program& program, Encoding codePage) {
  std::vector<Block> list;
  const auto add = [&list](Block block) {
    if (!block.empty()) list.push_back(std::move(block));
  };
  for (const auto& [id, block] : program) {
    if (id.type == mc5::BlockType::Db) add(writeFormats(block));
    if (id.type == mc5::BlockType::Fb) add(writeLabels(block));
    add(writeBlock(block, codePage));
    add(writeComments(program, block, codePage));
  }
  return list;
}

std::string eightOf(const std::string& name) {
  std::string text = source::toDos(upper(name), Encoding::Cp437).substr(0, kNameLength);
  text.resize(kNameLength, ' ');
  return text;
}

void putName(Block& bytes, std::size_t start, const std::string& name) {
  std::ranges::copy(name, bytes.begin() + static_cast<std::ptrdiff_t>(start + kName));
}

// A section with its header, filled up to whole records.
Block sectionOf(std::span<const Block> blocks, const std::string& name) {
  const std::size_t header = recordsFor(kDirectory + blocks.size() * kBlockEntry);
  Block section(header * kRecord, 0);
  for (const Block& block : blocks) {
    section.insert(section.end(), block.begin(), block.end());
    section.resize(recordsFor(section.size()) * kRecord, 0);
  }
  putName(section, 0, name);
  section[kHeaderRecords] = static_cast<std::uint8_t>(header);
  setLittle(section, kSize, static_cast<std::uint32_t>(section.size() / kRecord));
  section[kCount] = static_cast<std::uint8_t>(blocks.size());
  return section;
}

}  // namespace

std::vector<std::uint8_t> writeProgram(const mc5::Program& program, const std::string& name,
                                       Encoding codePage) {
  const std::vector<Block> blocks = blocksOf(program, codePage);
  const std::size_t sections =
      std::max<std::size_t>((blocks.size() + kMostInSection - 1) / kMostInSection, 1);
  const std::size_t header = recordsFor(kDirectory + sections * kSectionEntry);
  Block file(header * kRecord, 0);
  putName(file, 0, eightOf(name));
  file[kHeaderRecords] = static_cast<std::uint8_t>(header);
  file[kCount] = static_cast<std::uint8_t>(sections);
  for (std::size_t i = 0; i < sections; ++i) {
    const std::size_t first = i * kMostInSection;
    const std::size_t count = std::min(kMostInSection, blocks.size() - first);
    setLittle(file, kDirectory + i * kSectionEntry + kSectionRecord,
              static_cast<std::uint32_t>(file.size() / kRecord));
    const Block section = sectionOf(std::span(blocks).subspan(first, count), eightOf(name));
    file.insert(file.end(), section.begin(), section.end());
  }
  setLittle(file, kSize, static_cast<std::uint32_t>(file.size() / kRecord));
  return file;
}

}  // namespace merker::s5d
