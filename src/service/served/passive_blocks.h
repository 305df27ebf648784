// Blocks that clients have loaded into a CPU and that are not part of its program yet
// (S7-LIM-04): they lie in load memory until they are linked, deleted, or the CPU has a memory
// reset. In the thread of the PLC.
#pragma once

#include <map>
#include <vector>

#include "plc/controller.h"
#include "served/program_change.h"

namespace merker::served {

class PassiveBlocks {
 public:
  using Names = std::vector<s7comm::BlockName>;

  // Whether one of so many octets may come.
  s7comm::Error admit(controller::Controller& plc, const s7comm::BlockName& name,
                      std::size_t octets, std::string_view password) const;
  // It has been checked; `octets` of its container.
  s7comm::Error keep(controller::Controller& plc, std::shared_ptr<const block::Block> block,
                     std::size_t octets, std::string_view password);

  // What is to be changed in the program: all of these blocks or none.
  ProgramChange link(controller::Controller& plc, const Names& names,
                     const std::string& password) const;
  ProgramChange remove(controller::Controller& plc, const Names& names,
                       const std::string& password) const;
  // False: something else was changed meanwhile, and it must be planned again.
  bool carryOut(controller::Controller& plc, ProgramChange& change);

  const block::Block* find(BlockId id) const;
  void clear() { blocks_.clear(); }

 private:
  struct Kept {
    std::shared_ptr<const block::Block> block;
    std::size_t octets = 0;
  };
  std::size_t octets(BlockId except) const;

  std::map<BlockId, Kept> blocks_;
};

}  // namespace merker::served
