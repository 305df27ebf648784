// The structures of a data block that have a type of their own, which a data view names in place of
// STRUCT: data types (S7-TYPES-27) and instances within an instance.
#pragma once

#include <string>
#include <vector>

#include "block/block.h"
#include "source/symbol_table.h"

namespace merker::monitor {

struct DataStructure {
  std::string path;  // "Line.Motors[]": of an array its element, whatever its index
  std::string type;  // "\"Motor\"", without a symbol "UDT 1"
};

// Of each declaration once: their number does not grow with arrays.
std::vector<DataStructure> dataStructures(const block::Block& block,
                                          const source::SymbolTable& symbols);

}  // namespace merker::monitor
