// What a handler does when its instruction cannot be done as written.
#pragma once

#include "cpu/error.h"
#include "cpu/event.h"
#include "interpreter/op.h"

namespace merker::interpreter {

// Synchronous error, after the instruction has done what it can (S7-ERR-03): OB 121 or OB 122
// begins, or the CPU stops.
const Op* fail(cpu::Machine& m, const Op* op, const cpu::SyncError& error);
// Goes on behind `op`, or with the error OB if there is an error.
inline const Op* goOn(cpu::Machine& m, const Op* op, const cpu::SyncError& error) {
  return error ? fail(m, op, error) : op + 1;
}
// A fault that no OB handles.
const Op* stop(cpu::Machine& m, const Op* op, cpu::Event why);

// Handlers of what is no instruction: an unknown code, and the end of a block that has no BE.
const Op* unknownCode(cpu::Machine& m, const Op* op);
const Op* endOfCode(cpu::Machine& m, const Op* op);

}  // namespace merker::interpreter
