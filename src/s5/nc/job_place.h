// The words of the PLC that a job reads or writes (S5-FM-28, -32).
#pragma once

#include <span>

#include "nc/job.h"

namespace merker::nc {

// Whether all words of the job are there; what is written must not lie in the EPROM.
bool placeExists(sinumerik::Machine& machine, const Job& job);

PlcValue readValue(sinumerik::Machine& machine, const Job& job, unsigned index);
// The left byte of the first word of a BCD value is free: it stays (S5-FM-37).
void writeValue(sinumerik::Machine& machine, const Job& job, unsigned index, PlcValue value);

}  // namespace merker::nc
