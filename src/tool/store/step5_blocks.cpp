#include "store/step5_blocks.h"

#include <span>

#include "base/bytes.h"
#include "control/buffered.h"
#include "mc5/word_bytes.h"

namespace merker::cnc {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kNameBytes = 8, kLibraryBytes = 4;  // even, as code is

block::Block stored(const mc5::Block& block) {
  block::Block result;
  result.id = onCard(block.id);
  appendDWord(result.code, block.library);
  for (std::size_t i = 0; i < kNameBytes; ++i)
    result.code.push_back(i < block.name.size() ? static_cast<std::uint8_t>(block.name[i]) : ' ');
  const Bytes words = mc5::toBytes(block.words);
  result.code.insert(result.code.end(), words.begin(), words.end());
  return result;
}

std::optional<mc5::Block> taken(const block::Block& block) {
  const Bytes& code = block.code;
  const bool type = block.id.kind == BlockKind::FC &&
                    block.id.number >> 8 <= static_cast<unsigned>(mc5::BlockType::Db);
  if (!type || code.size() < kLibraryBytes + kNameBytes) return std::nullopt;
  mc5::Block result;
  result.id = blockOf(block.id);
  result.library = loadDWord(code.data());
  result.name.assign(code.begin() + kLibraryBytes, code.begin() + kLibraryBytes + kNameBytes);
  result.name.erase(result.name.find_last_not_of(' ') + 1);
  result.words = mc5::toWords(std::span(code).subspan(kLibraryBytes + kNameBytes));
  return result;
}

}  // namespace

block::Program toCard(const mc5::Program& program) {
  block::Program result;
  for (const auto& [id, block] : program) {
    block::Block one = stored(block);
    result.emplace(one.id, std::move(one));
  }
  return result;
}

std::optional<mc5::Program> fromCard(const block::Program& blocks) {
  mc5::Program program;
  for (const auto& [id, block] : blocks) {
    auto one = taken(block);
    if (!one) return std::nullopt;
    program.emplace(one->id, std::move(*one));
  }
  return program;
}

}  // namespace merker::cnc
