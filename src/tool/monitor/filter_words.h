// What a filter of the cross reference may name beside single operands, for each family.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "address/block_id.h"
#include "address/reference.h"
#include "monitor/code.h"

namespace merker::monitor {

struct AreaWord {
  std::string_view word;  // "E"
  address::OperandKind kind;
  Area area;  // Memory
};

struct FilterWords {
  std::span<const AreaWord> areas;
  std::span<const BlockKind> blocks;
  // "DBW 4", "DW 2": data of any block, as of DB 0.
  std::optional<address::Operand> (*data)(std::string_view text);
};

const FilterWords& step7Words();
const FilterWords& step5Words();
const FilterWords& filterWords(const ProgramCode& program);

}  // namespace merker::monitor
