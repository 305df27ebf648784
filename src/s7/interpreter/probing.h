// Blocks with a probe run each instruction through one more handler; all others do not know of it.
#pragma once

#include "cpu/probe.h"
#include "interpreter/translated.h"

namespace merker::interpreter {

// Replaces the handlers of all instructions, or puts them back when `probe` is null.
void setProbe(Translated& code, cpu::Probe* probe);

}  // namespace merker::interpreter
