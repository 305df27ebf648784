#include "monitor/program_status.h"

#include <algorithm>

namespace merker::monitor {
namespace {

// A list to choose from; a program that makes its data blocks may have any number.
constexpr std::size_t kMostInstances = 256;

}  // namespace

ProgramStatus::ProgramStatus(const BlockCode& code, CallEnvironment environment,
                             std::vector<CallValues> values)
    : kept_(code), environment_(environment), callValues_(std::move(values)) {
  for (std::size_t i = 0; i < code.lineCount(); ++i) {
    const Statement statement = statementAt(code, code.line(i).offset);
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
  const auto found = rows_.find(statementAt(code(), offset).begin);
  return found == rows_.end() || !found->second.reached ? nullptr : &found->second;
}

bool ProgramStatus::wanted(const Registers& registers, const Spot& spot) const {
  if (environment_.caller && spot.caller() != environment_.caller) return false;
  if (environment_.db && registers.db != *environment_.db) return false;
  return !environment_.di || registers.di == environment_.di;
}

void ProgramStatus::arrived(const Spot& spot) {
  while (!open_.empty() && open_.back().frames > spot.depth.frames) open_.pop_back();
  if (open_.empty() || open_.back().frames != spot.depth.frames) return;
  // the block that it called has come back
  record(open_.back().found, spot.registers(), open_.back().offset);
  open_.pop_back();
}

void ProgramStatus::begin(const Spot& spot) {
  const Registers registers = spot.registers();
  recording_ = wanted(registers, spot);
  ++(recording_ ? calls_ : otherCalls_);
  const bool hasInstance = code().id().kind == BlockKind::FB && registers.di.value_or(0) != 0;
  if (hasInstance && instances_.size() < kMostInstances) instances_.insert(*registers.di);
  if (!recording_) return;
  instance_ = hasInstance ? registers.di : std::nullopt;
  for (auto& [offset, row] : rows_) row.reached = false, row.passes = 0;
}

void ProgramStatus::before(const Spot& spot) {
  if (spot.offset == 0 && running_ != spot.depth.frames) begin(spot);  // no jump to the beginning
  if (recording_) readValues(spot, false);
  running_ = spot.depth.frames;
  if (recording_) open_.push_back({spot.depth.frames, spot.offset, spot.registers()});
}

// The BE that the compiler adds belongs to no statement, though the last one reaches up to it.
void ProgramStatus::after(const Spot& spot) {
  const bool ended = spot.levelEnded || spot.depth.frames < running_;
  const bool known = !open_.empty();
  const Registers found = known ? open_.back().found : spot.registers();
  if (known) open_.pop_back();
  if (recording_ && !ended) readValues(spot, true);
  if (recording_ && !ended) record(found, spot.registers(), spot.offset);
  if (recording_ && ended && beginsStatement(code(), spot.offset)) recordOne(found, spot.offset);
  if (ended || spot.stopped) running_ = 0;
}

// What goes in before the first instruction of a CALL, what comes out behind its last one.
void ProgramStatus::readValues(const Spot& spot, bool behind) {
  const auto offset = behind ? &CallValues::last : &CallValues::first;
  const auto call = std::ranges::lower_bound(callValues_, spot.offset, {}, offset);
  if (call == callValues_.end() || (*call).*offset != spot.offset) return;
  for (std::size_t i = 0; i < call->operands.size(); ++i)
    if (call->operands[i].output == behind) call->values[i] = spot.value(call->operands[i]);
}

// B of STEP 5 leaves everything as it found it; what it processes stands in the next row.
void ProgramStatus::record(const Registers& found, const Registers& left, std::uint32_t offset) {
  const std::uint32_t processed = code().processedAt(offset);
  if (processed != offset) recordOne(found, offset);
  recordOne(left, processed);
}

void ProgramStatus::recordOne(const Registers& registers, std::uint32_t offset) {
  StatusRow& row = rows_[statementAt(code(), offset).begin];
  row.reached = true;
  if (row.statement.begin == offset) ++row.passes;
  row.after = registers;
}

}  // namespace merker::monitor
