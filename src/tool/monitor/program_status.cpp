#include "monitor/program_status.h"

#include "cpu/cpu.h"

namespace merker::monitor {

ProgramStatus::ProgramStatus(const block::Block& block, CallEnvironment environment)
    : block_(block), environment_(environment) {
  for (const block::LineEntry& entry : block.lines) {
    const Statement statement = statementAt(block, entry.offset);
    rows_[statement.begin].statement = statement;
  }
}

std::vector<StatusRow> ProgramStatus::rows() const {
  std::vector<StatusRow> list;
  for (const auto& [begin, row] : rows_)
    if (row.statement.line != 0) list.push_back(row);
  return list;
}

const StatusRow* ProgramStatus::at(std::uint32_t offset) const {
  const auto found = rows_.find(statementAt(block_, offset).begin);
  return found == rows_.end() || !found->second.reached ? nullptr : &found->second;
}

bool ProgramStatus::wanted(const cpu::Machine& m) const {
  const cpu::Frame* caller = m.caller();
  if (environment_.caller &&
      (caller == nullptr || caller->code->source->id != *environment_.caller))
    return false;
  if (environment_.db && m.registers.db.number != *environment_.db) return false;
  return !environment_.di || m.registers.di.number == *environment_.di;
}

void ProgramStatus::arrived(const cpu::Machine& m) {
  while (!open_.empty() && open_.back().frames > m.frames.size()) open_.pop_back();
  if (open_.empty() || open_.back().frames != m.frames.size()) return;
  record(m.registers, open_.back().offset);  // the block that it called has come back
  open_.pop_back();
}

void ProgramStatus::before(const cpu::Machine& m, std::uint32_t offset) {
  if (offset == 0 && running_ != m.frames.size()) {  // a call, no jump to the beginning
    recording_ = wanted(m);
    if (recording_) ++calls_;
    for (auto& [begin, row] : rows_)
      if (recording_) row.reached = false, row.passes = 0;
  }
  running_ = m.frames.size();
  if (recording_) open_.push_back({m.frames.size(), offset, m.registers});
}

// The BE that the compiler adds belongs to no statement, though the last one reaches up to it.
void ProgramStatus::after(const cpu::Machine& m, std::uint32_t offset) {
  const bool ended = m.levelEnded || m.frames.size() < running_;
  const bool known = !open_.empty();
  const cpu::Registers found = known ? open_.back().found : m.registers;
  if (known) open_.pop_back();
  if (recording_ && !ended) record(m.registers, offset);
  if (recording_ && ended && beginsStatement(block_, offset)) record(found, offset);
  if (ended || m.cpu->mode() == cpu::Mode::Stop) running_ = 0;
}

void ProgramStatus::record(const cpu::Registers& registers, std::uint32_t offset) {
  StatusRow& row = rows_[statementAt(block_, offset).begin];
  row.reached = true;
  if (row.statement.begin == offset) ++row.passes;
  row.after = registers;
}

}  // namespace merker::monitor
