#include "system/function_table.h"

#include <map>
#include <mutex>
#include <tuple>

#include "block/width.h"
#include "system/library.h"

namespace merker::system {

template <typename Self>
auto& FunctionTable::entriesOf(Self& self, BlockKind kind) {
  switch (kind) {
    case BlockKind::FC:
      return self.fcs_;
    case BlockKind::FB:
      return self.fbs_;
    case BlockKind::SFC:
      return self.sfcs_;
    default:
      return self.sfbs_;
  }
}

FunctionTable::FunctionTable(const CpuModel& model, const Libraries& libraries)
    : functions_(allFunctions(model, libraries)) {
  const block::Program blocks = library(model, libraries);
  for (const Function& function : functions_) {
    Entries& entries = entriesOf(*this, function.kind);
    if (entries.size() <= function.number) entries.resize(function.number + 1u);
    Entry& entry = entries[function.number];
    entry.function = &function;
    const auto& variables = blocks.at({function.kind, function.number}).variables;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
      entry.places.push_back({i < variables.size() ? variables[i].address : 0,
                              block::widthOf(function.parameters[i].type)});
  }
}

const FunctionTable::Entry* FunctionTable::find(BlockId id) const {
  const Entries& entries = entriesOf(*this, id.kind);
  const bool known = id.number < entries.size() && entries[id.number].function != nullptr;
  return known ? &entries[id.number] : nullptr;
}

std::shared_ptr<const FunctionTable> functionTable(const CpuModel& model,
                                                   const Libraries& libraries) {
  // What allFunctions() asks of a model.
  using Numbers = std::vector<std::uint8_t>;
  using Key = std::tuple<Numbers, Numbers, Libraries>;
  static std::mutex mutex;
  static std::map<Key, std::shared_ptr<const FunctionTable>> tables;
  const Key key{Numbers(model.lacksSfcs.begin(), model.lacksSfcs.end()),
                Numbers(model.lacksSfbs.begin(), model.lacksSfbs.end()), libraries};
  const std::scoped_lock lock(mutex);
  auto& table = tables[key];
  if (table == nullptr) table = std::make_shared<FunctionTable>(model, libraries);
  return table;
}

}  // namespace merker::system
