// AUF and TDB (S7-INSTR-47, -48).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

using cpu::ErrorCode;
using cpu::SyncError;

SyncError check(const cpu::Machine& m, std::uint32_t number, bool instance) {
  if (static_cast<std::int64_t>(number) > m.model->highestDb)
    return {.code = instance ? ErrorCode::DiNumber : ErrorCode::DbNumber, .detail = number};
  if (number != 0 && m.dataBlocks.find(number) == nullptr)
    return {.code = ErrorCode::DbMissing, .detail = number};
  return {};
}

// Number 0, or a block that is not there: nothing is open afterwards.
const Op* open(cpu::Machine& m, const Op* op) {
  std::uint32_t number = 0;
  SyncError error = numberOperand(m, op, number);
  const bool instance = op->reg == 1;
  if (!error) error = check(m, number, instance);
  (instance ? m.registers.di : m.registers.db) =
      error ? cpu::OpenBlock{} : m.dataBlocks.open(number);
  return goOn(m, op, error);
}

const Op* exchange(cpu::Machine& m, const Op* op) {
  std::swap(m.registers.db, m.registers.di);
  return op + 1;
}

}  // namespace

Rows dataBlockRows() {
  return {{mc7::Operation::OPEN, Form::Other, open},
          {mc7::Operation::SWAP_DB, Form::None, exchange}};
}

}  // namespace merker::interpreter
