// The stacks of a CPU in STOP or HALT as programming devices read them (S7-DIAG-04).
#pragma once

#include "monitor/stacks.h"
#include "s7comm/test_job.h"

namespace merker::served {

// Type, number, address.
void appendPlace(s7comm::Bytes& data, const monitor::SourcePlace& place);
// The registers of the priority class that was running, and the start information of its OB.
s7comm::Bytes interruptStackData(const monitor::Stacks& stacks);
// Every block, the running one first; an OB ends its priority class.
s7comm::Bytes blockStackData(const monitor::Stacks& stacks);
// Local data of one block: of this priority class, so many blocks above its OB. None: there is no
// such block.
s7comm::Bytes localStackData(const monitor::Stacks& stacks, std::uint8_t priority,
                             std::uint8_t depth);

}  // namespace merker::served
