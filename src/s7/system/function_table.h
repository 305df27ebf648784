// The functions of a CPU by kind and number, with the places of their parameters in an instance. It
// never changes, so all stations with the same functions share one.
#pragma once

#include <memory>
#include <vector>

#include "block/block.h"
#include "catalogue/block_library.h"
#include "catalogue/cpu_model.h"
#include "system/arguments.h"
#include "system/function.h"

namespace merker::system {

class FunctionTable {
 public:
  struct Entry {
    const Function* function = nullptr;
    std::vector<ParameterPlace> places;
  };

  FunctionTable(const CpuModel& model, const Libraries& libraries);
  FunctionTable(const FunctionTable&) = delete;  // entries point into functions_
  FunctionTable& operator=(const FunctionTable&) = delete;

  const Entry* find(BlockId id) const;  // null: not a function of this CPU

 private:
  std::vector<Function> functions_;
  using Entries = std::vector<Entry>;  // by number
  Entries fcs_, fbs_, sfcs_, sfbs_;
  template <typename Self>
  static auto& entriesOf(Self& self, BlockKind kind);
};

// From any thread. Made once for all models with the same functions: a program that runs a thousand
// stations, or one after the other for a thousand tests, has one table.
std::shared_ptr<const FunctionTable> functionTable(const CpuModel& model,
                                                   const Libraries& libraries);

}  // namespace merker::system
