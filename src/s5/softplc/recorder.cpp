#include "softplc/recorder.h"

#include <algorithm>

#include "softplc/check_value.h"

namespace merker::sinumerik {
namespace {

using mc5::OperandKind;

// Words of the instruction at `word`; a call of an FB has its jump and its list with it.
std::size_t lengthAt(const std::vector<std::uint16_t>& words, std::size_t word) {
  const auto decoded = mc5::decode(std::span(words).subspan(word));
  if (!decoded) return 1;
  const mc5::Operand& operand = decoded->instruction.operand;
  const bool call = operand.kind == OperandKind::Block && operand.block == mc5::BlockType::Fb &&
                    decoded->instruction.operation != mc5::Operation::OPEN;
  const std::size_t jump = word + decoded->words;
  const bool list = call && jump < words.size() && words[jump] >> 8 == 0x2D;
  return decoded->words + (list ? words[jump] & 0xFFu : 0u);
}

// The instruction that a check belongs to: at its offset, or the one in which it lies.
std::uint32_t instructionOf(const std::vector<std::uint16_t>& words, std::uint32_t offset) {
  std::size_t word = 0;
  for (;;) {
    const std::size_t next = word + lengthAt(words, word);
    if (next > offset || next >= words.size()) return static_cast<std::uint32_t>(word);
    word = next;
  }
}

// A step counter before the instruction is far behind it, too.
bool leadsAway(Machine& m, std::uint32_t word) {
  return m.frame().next - word > lengthAt(m.blocks.program(), word);
}

bool sameCode(const mc5::Block& block, const Entry& entry, const BlockMemory& memory) {
  return entry.present && entry.length == block.words.size() &&
         std::equal(block.words.begin(), block.words.end(), memory.program().begin() + entry.start);
}

}  // namespace

Recorder::Recorder(const mc5::Program& program, bool coverage)
    : program_(program), coverage_(coverage) {
  for (const auto& [id, block] : program_)
    for (const block::Check& check : block.checks)
      records_.push_back({&block, block::CheckRecord(check)});
}

void Recorder::attach(const BlockMemory& blocks) {
  version_ = blocks.version();
  byWord_.clear();
  for (const auto& [id, block] : program_)
    if (id.type != mc5::BlockType::Db && !block.checks.empty()) attachTo(block, blocks);
}

void Recorder::attachTo(const mc5::Block& block, const BlockMemory& blocks) {
  const Entry& entry = blocks.find(block.id);
  if (!sameCode(block, entry, blocks)) return;  // replaced by another one
  for (std::size_t i = 0; i < records_.size(); ++i)
    if (records_[i].block == &block)
      byWord_.emplace(entry.start + instructionOf(block.words, records_[i].check.check().offset),
                      i);
}

std::vector<bool> Recorder::watched(const BlockMemory& blocks) {
  if (version_ != blocks.version()) attach(blocks);
  std::vector<bool> words(blocks.program().size());
  for (const auto& [word, record] : byWord_) words[word] = true;
  return words;
}

void Recorder::beforeStep(const Machine& m) {
  if (version_ != m.blocks.version()) attach(m.blocks);
  const Level& level = m.levels.back();
  const Frame& frame = level.frames.back();
  now_ = {m.levels.size(), level.frames.size(), frame.block, frame.start, frame.next, 0};
}

void Recorder::count(const Place& place, std::uint32_t word) {
  ++executed_[place.block][word - place.start];
}

void Recorder::afterStep(Processor& p, Outcome outcome) {
  if (coverage_) count(now_, now_.word);
  now_.last = p.lastWord();
  if (coverage_ && now_.last != now_.word) count(now_, now_.last);
  if (outcome == Outcome::Trapped) return;
  Machine& m = p.machine();
  const bool ended = outcome == Outcome::LevelEnded;
  if (ended) {  // a check of BE looks at what it leaves behind
    m.levels.push_back(p.endedLevel());
    m.level().frames.push_back({});
  }
  const std::size_t depth = ended ? 0 : m.level().frames.size();
  if (depth > now_.depth) {
    calls_.push_back(now_);
  } else {
    const bool away = depth < now_.depth || leadsAway(m, now_.last);
    evaluate(p, now_, away);
    if (depth < now_.depth) returned(p);
  }
  if (ended) m.levels.pop_back();
}

// A block has ended: the check of its call is due.
void Recorder::returned(Processor& p) {
  const std::size_t level = now_.level, depth = now_.depth;
  while (!calls_.empty() && calls_.back().level == level && calls_.back().depth + 1 >= depth) {
    const Place call = calls_.back();
    calls_.pop_back();
    if (call.depth + 1 == depth) evaluate(p, call, false);
  }
}

void Recorder::evaluate(Processor& p, const Place& place, bool away) {
  evaluateAt(p, place.word, away);
  if (place.last != place.word) evaluateAt(p, place.last, away);
}

void Recorder::evaluateAt(Processor& p, std::uint32_t word, bool away) {
  const auto [first, last] = byWord_.equal_range(word);
  for (auto it = first; it != last; ++it) {
    block::CheckRecord& record = records_[it->second].check;
    record.evaluate(p.machine().clock, away,
                    [&](std::size_t i) { return judge(p, record.check().terms[i]); });
  }
}

std::vector<CheckResult> Recorder::results() const {
  std::vector<CheckResult> list;
  for (const Record& record : records_) list.push_back(record.check.result());
  return list;
}

}  // namespace merker::sinumerik
