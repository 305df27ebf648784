// A value that someone outside the program looks at: an operand, the data block it is in, and its
// type.
#pragma once

#include <cstdint>
#include <string>

#include "address/type_code.h"
#include "mc7/operand.h"

namespace merker::mc7 {

struct Reference {
  std::string text;                // as the user wrote it
  Operand operand;                 // Memory, Timer or Counter; area DataBlock together with `db`
  std::int32_t db = -1;            // number of the data block, -1 outside of data blocks
  TypeCode type = TypeCode::Void;  // of a typed variable or symbol; Void for an absolute operand
  bool outputSide = false;         // of the periphery: PA, else PE
  std::uint32_t bytes = 0;  // of a DATE_AND_TIME or STRING, which no `operand.width` holds; else 0
  std::uint32_t nc = 0;     // a datum of the NC of a SINUMERIK, packed (nc/datum.h); else 0
  bool partner = false;     // of the control that is coupled with this one
};

}  // namespace merker::mc7
