#include "softplc/probes.h"

#include <algorithm>
#include <utility>

#include "mc5/encoding.h"
#include "mc5/parameter_list.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockType;

bool contains(const Entry& block, std::uint32_t word) {
  return block.present && word - block.start < block.length;
}

// The block in whose code the word lies; where there is none, the one that runs.
mc5::BlockId blockAt(const BlockMemory& blocks, const Frame& running) {
  if (contains(blocks.find(running.block), running.next)) return running.block;
  for (const BlockType type : {BlockType::Ob, BlockType::Pb, BlockType::Sb, BlockType::Fb}) {
    const auto list = blocks.list(type);
    for (std::size_t number = 0; number < list.size(); ++number)
      if (contains(list[number], running.next)) return {type, static_cast<std::uint16_t>(number)};
  }
  return running.block;
}

CodePlace placeIn(const Machine& m, mc5::BlockId block, std::uint32_t start) {
  std::size_t frames = 0;
  for (const Level& level : m.levels) frames += level.frames.size();
  return {block, m.levels.back().frames.back().next - start, m.levels.size(), frames};
}

// The words behind a call that are none of its statements: the jump over the parameters, and these.
// Nothing if there are none.
std::uint32_t listBehind(std::span<const std::uint16_t> code, std::uint32_t word,
                         const mc5::Decoded& decoded) {
  const std::uint32_t jump = word + decoded.words;
  if (!mc5::callsFunctionBlock(decoded.instruction)) return 0;
  return mc5::endOfList(code, jump).value_or(jump) - jump;
}

}  // namespace

std::optional<CodePlace> nextPlace(const Machine& m) {
  if (m.levels.empty() || m.levels.back().frames.empty()) return std::nullopt;
  const Frame& frame = m.levels.back().frames.back();
  const mc5::BlockId block = blockAt(m.blocks, frame);
  return placeIn(m, block, block == frame.block ? frame.start : m.blocks.find(block).start);
}

void Probes::place(mc5::BlockId block, Probe* probe) {
  if (probe != nullptr)
    placed_[block] = probe;
  else
    placed_.erase(block);
  version_ = ~std::uint64_t{0};
  asked_ = nullptr;
}

void Probes::attach(const BlockMemory& blocks) {
  if (version_ == blocks.codeVersion()) return;
  version_ = blocks.codeVersion();
  watched_.clear();
  byWord_.assign(blocks.program().size(), 0);
  for (const auto& [block, probe] : placed_) {
    const Entry& entry = blocks.find(block);
    if (!entry.present) continue;
    watched_.push_back({block, entry.start, entry.length, probe});
    attachTo(watched_.back(), blocks.program());
  }
}

void Probes::attachTo(const Watched& watched, const std::vector<std::uint16_t>& program) {
  const auto number = static_cast<std::uint16_t>(watched_.size());
  const auto words = byWord_.begin() + watched.start;
  std::fill_n(words, watched.length, number);
  const auto code = std::span(program).subspan(watched.start, watched.length);
  for (std::uint32_t word = 0; word < code.size();) {
    const auto decoded = mc5::decode(code.subspan(word));
    const std::uint32_t list = decoded ? listBehind(code, word, *decoded) : 0;
    word += decoded ? decoded->words : 1;
    std::fill_n(words + word, list, std::uint16_t{0});
    word += list;
  }
}

bool Probes::before(const Machine& m) {
  attach(m.blocks);
  asked_ = nullptr;
  const std::uint32_t word = m.levels.back().frames.back().next;
  const std::uint16_t number = word < byWord_.size() ? byWord_[word] : std::uint16_t{0};
  if (number == 0) return false;
  const Watched& watched = watched_[number - 1u];
  const CodePlace place = placeIn(m, watched.block, watched.start);
  Probe* const probe = watched.probe;
  if (probe->before(m, place)) return true;
  asked_ = probe;
  now_ = place;
  return false;
}

void Probes::after(const Processor& p, Outcome outcome) {
  if (asked_ == nullptr) return;
  Probe* const probe = std::exchange(asked_, nullptr);
  const Machine& m = p.machine();
  const bool levelEnded = outcome == Outcome::LevelEnded;
  const std::size_t frames = levelEnded ? 0 : placeIn(m, {}, 0).frames;
  if (frames > now_.frames) return;
  const Registers& registers = levelEnded ? p.endedLevel().registers : m.levels.back().registers;
  probe->after(m, now_,
               {.registers = registers,
                .blockEnded = frames < now_.frames,
                .levelEnded = levelEnded,
                .trapped = outcome == Outcome::Trapped});
}

void Probes::addTo(std::vector<bool>& words, const BlockMemory& blocks) {
  attach(blocks);
  for (const Watched& one : watched_) std::fill_n(words.begin() + one.start, one.length, true);
}

}  // namespace merker::sinumerik
