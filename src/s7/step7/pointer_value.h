// P#M10.0, P#DB10.DBX4.0 WORD 5: what POINTER and ANY are supplied with (S7-IND-11, -12, -15).
#pragma once

#include <optional>

#include "address/type_code.h"
#include "source/source_file.h"
#include "step7/cursor.h"

namespace merker::step7 {

struct PointerValue {
  std::uint16_t db = 0;          // 0: none
  std::uint32_t pointer = 0;     // area and bit address
  std::optional<TypeCode> type;  // with a count: an ANY; without: a POINTER
  std::uint16_t count = 0;
};

// Reads from P# on. Nothing after a problem.
std::optional<PointerValue> readPointer(Cursor& cursor, const source::SourceFile& file,
                                        Problems& problems);

}  // namespace merker::step7
