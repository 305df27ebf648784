#include "monitor/reference_rows.h"

#include "monitor/symbol_name.h"

namespace merker::monitor {

void ReferenceRows::arrive(std::uint32_t offset) {
  offset_ = offset;
  const bool lines = block_.lineCount() > 0;
  const std::uint32_t begin = lines ? statementAt(block_, offset).begin : offset;
  if (begin == statement_) return;
  statement_ = begin;
  first_ = out_.size();
}

void ReferenceRows::add(CrossReference row, Use use, std::string instruction) {
  row.use = use;
  row.place = sourcePlace(block_, offset_);
  row.statement = statementNumber(block_, offset_);
  row.instruction = std::move(instruction);
  if (const source::Symbol* symbol = symbolOf(row)) row.symbol = symbol->name;
  if (!merged(row)) out_.push_back(std::move(row));
}

// A CALL reads one operand several times; IN_OUT reads and writes it.
bool ReferenceRows::merged(const CrossReference& row) {
  for (std::size_t i = first_; i < out_.size(); ++i) {
    CrossReference& old = out_[i];
    if (old.operand != row.operand || (old.use == Use::Call) != (row.use == Use::Call)) continue;
    if (old.use != row.use) old.use = Use::ReadWrite;
    return true;
  }
  return false;
}

const source::Symbol* ReferenceRows::symbolOf(const CrossReference& row) const {
  if (row.bits != 0 || row.formal != 0) return nullptr;
  if (row.block) return findSymbol(*row.block, symbols_);
  return findSymbol(row.key, row.use == Use::Write, symbols_);
}

}  // namespace merker::monitor
