// What the battery of a control keeps without power, in the form in which a memory card holds it:
// segments 5 and 6 of the PLC (9.1, note 2; S5-MEM-09), and the data of the NC
// (docs/formats/card.md).
#pragma once

#include <optional>

#include "block/block.h"
#include "block/retentive.h"
#include "control/cnc.h"

namespace merker::cnc {

// The blocks of a program as a card holds them.
block::Program toCard(const mc5::Program& program);
// Nothing if these are no blocks of STEP 5. Names of parameters, lines and formats are not on a
// card.
std::optional<mc5::Program> fromCard(const block::Program& blocks);
mc5::BlockId blockOf(BlockId onCard);

// What is kept at the end of a cycle. Calls for the same `keeper` cost little when little changed.
class Keeper {
 public:
  const block::RetentiveData& look(Cnc& control);

 private:
  block::RetentiveData data_;
  std::optional<nc::Control> seen_;
};

// For a new control: it is then switched off and has this in its memory. False: this is nothing
// that a control keeps; it is as it was.
bool restore(Cnc& control, const block::RetentiveData& data);

}  // namespace merker::cnc
