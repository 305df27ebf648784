// What the battery of a control keeps without power, in the form in which a memory card holds it:
// segments 5 and 6 of the PLC (9.1, note 2; S5-MEM-09), and the data of the NC
// (docs/formats/card.md).
#pragma once

#include <optional>

#include "mc5/block.h"
#include "nc/control.h"
#include "plc/retentive.h"

namespace merker::cnc {

class Cnc;

// The name of a block on the card, and back.
BlockId onCard(mc5::BlockId id);
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
