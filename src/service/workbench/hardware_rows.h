// The racks as rows of an answer.
#pragma once

#include "io/rack.h"
#include "source/symbol_table.h"
#include "workbench/json.h"

namespace merker::workbench {

// As the page knows it: "digital".
std::string_view kindOf(ModuleKind kind);

// A module without its parameters.
Json moduleRow(const io::Module& module, const io::Rack* rack, const source::SymbolTable& symbols);

// The CPU, which stands in slot 2 of rack 0; `properties`: pairs of name and value.
Json cpuRow(std::string_view order, std::string_view name, Json properties);

// `rack`: the modules in operation; null: without a hardware configuration none can have a fault.
Json hardwareRows(const io::Configuration& configuration, const io::Rack* rack,
                  const source::SymbolTable& symbols);

}  // namespace merker::workbench
