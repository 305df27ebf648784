// The PLCs inside SINUMERIK 810/820 GA3 (S5-OPC-07): what --cpu and [cpu] model name.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace merker {

struct SinumerikModel {
  std::string_view name;  // "SINUMERIK 810 GA3"; case and blanks do not matter
  bool acop;              // word coprocessor; COP is software 1
};

std::span<const SinumerikModel> sinumerikModels();
const SinumerikModel& defaultSinumerikModel();                    // SINUMERIK 810 GA3, ACOP
const SinumerikModel* findSinumerikModel(std::string_view name);  // null if unknown
// "SINUMERIK 810 GA3, …", for problems
std::string sinumerikModelNames();

}  // namespace merker
