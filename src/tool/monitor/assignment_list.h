// The assignment list: which bits of E, A and M the program uses, and by which wider access; which
// timers and counters (S7-EDIT-22).
#pragma once

#include <array>
#include <vector>

#include "monitor/cross_reference.h"

namespace merker::monitor {

struct AssignmentByte {
  Area area = Area::Flag;  // Input, Output, Flag
  std::uint32_t byte = 0;
  std::array<bool, 8> bits{};                            // [7] is bit 7: accessed as a bit
  bool byByte = false, byWord = false, byDWord = false;  // part of such an access
};

struct AssignmentList {
  std::vector<AssignmentByte> bytes;  // used ones only, by area and address
  std::vector<std::uint32_t> timers, counters;
};

AssignmentList assignmentList(const std::vector<CrossReference>& list);

}  // namespace merker::monitor
