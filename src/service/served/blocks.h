// The blocks of a CPU as programming devices fetch them, in its thread.
#pragma once

#include <optional>
#include <vector>

#include "address/block_id.h"
#include "catalogue/cpu_model.h"
#include "plc/controller.h"
#include "s7comm/plc.h"
#include "served/passive_blocks.h"

namespace merker::served {

// Nothing: a machine without blocks of this kind.
std::optional<std::vector<s7comm::BlockEntry>> blocksOf(controller::Controller& plc);

// That the CPU can hold: system data have numbers of their own, SFC and SFB are its own.
bool hasNumber(const CpuModel& model, BlockId id);

struct Uploaded {
  s7comm::Error error = s7comm::Error::NoSuchBlock;
  s7comm::Bytes container{};
};

// A data block has the values that it has now.
Uploaded blockOf(controller::Controller& plc, const PassiveBlocks& passive,
                 const s7comm::BlockName& name);
// The same for somebody who wants its code: protection level 3 asks for the password.
Uploaded upload(controller::Controller& plc, const PassiveBlocks& passive,
                const s7comm::BlockName& name, std::string_view password = {});

}  // namespace merker::served
