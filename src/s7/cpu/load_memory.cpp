#include "cpu/load_memory.h"

#include <algorithm>
#include <utility>

#include "cpu/same_code.h"

namespace merker::cpu {
namespace {

const block::Block* findBlock(const block::Program* program, BlockId id) {
  if (program == nullptr) return nullptr;
  const auto found = program->find(id);
  return found == program->end() ? nullptr : &found->second;
}

using Table = std::vector<const Code*>;

Table* tableOf(Machine& m, BlockKind kind) {
  switch (kind) {
    case BlockKind::FC:
      return &m.functions;
    case BlockKind::FB:
      return &m.functionBlocks;
    case BlockKind::OB:
      return &m.organizationBlocks;
    default:
      return nullptr;
  }
}

void enter(Table& table, std::uint32_t number, const Code* code) {
  if (table.size() <= number) table.resize(number + 1);
  table[number] = code;
}

}  // namespace

bool LoadMemory::probe(BlockId block, Probe* probe) const {
  const auto newest = std::find_if(code_.rbegin(), code_.rend(),
                                   [&](const auto& code) { return code->source->id == block; });
  if (newest == code_.rend()) return false;
  engine_.probe(**newest, probe);
  return true;
}

// A block whose code stays the same keeps its translation, so that checks and coverage go on.
void LoadMemory::translate(const block::Program* before) {
  Machine& m = machine_;
  const Table functions = std::exchange(m.functions, {});
  const Table functionBlocks = std::exchange(m.functionBlocks, {});
  const Table organizationBlocks = std::exchange(m.organizationBlocks, {});
  for (const auto& [id, source] : *program_) {
    Table* table = tableOf(m, id.kind);
    if (table == nullptr) continue;
    const block::Block* old = findBlock(before, id);
    if (old != nullptr && sameCode(*old, source)) {
      const Table& kept = id.kind == BlockKind::FC   ? functions
                          : id.kind == BlockKind::FB ? functionBlocks
                                                     : organizationBlocks;
      enter(*table, id.number, find(kept, id.number));
    } else {
      code_.push_back(engine_.translate(source));
      enter(*table, id.number, code_.back().get());
    }
  }
}

void LoadMemory::load(std::shared_ptr<const block::Program> program) {
  program_ = std::move(program);
  downloaded_ = nullptr;
  oldPrograms_.clear();
  code_.clear();
  translate(nullptr);
}

void LoadMemory::activate() {
  const std::shared_ptr<const block::Program> before = std::exchange(program_, downloaded_);
  downloaded_ = nullptr;
  translate(before.get());
  exchangeData(*before);
  machine_.reopenBlocks();
  if (engine_.keepsOldCode() || machine_.frames.size() > 1)
    oldPrograms_.push_back(before);
  else
    dropOldCode();
}

void LoadMemory::exchangeData(const block::Program& before) {
  for (const auto& [id, source] : before)
    if (id.kind == BlockKind::DB && !program_->contains(id)) machine_.dataBlocks.remove(id.number);
  for (const auto& [id, source] : *program_) {
    if (id.kind != BlockKind::DB) continue;
    const block::Block* old = findBlock(&before, id);
    if (old == nullptr || !sameData(*old, source)) machine_.dataBlocks.load(source);
  }
}

// No block runs: what is in no table is gone for good, the rest belongs to the program of now.
void LoadMemory::dropOldCode() {
  const auto loaded = [this](BlockId id) { return find(*tableOf(machine_, id.kind), id.number); };
  std::erase_if(code_, [&](const auto& code) { return loaded(code->source->id) != code.get(); });
  for (const auto& code : code_) code->source = &program_->at(code->source->id);
  oldPrograms_.clear();
}

}  // namespace merker::cpu
