// NAME and BEZ lines at the beginning of a function block (S5-FB-07 … -12).
#pragma once

#include <cstddef>

#include "mc5/block.h"
#include "step5/block_source.h"

namespace merker::step5 {

struct Declaration {
  std::string name;      // of the head of the block, without one that of the line NAME
  std::string nameLine;  // what NAME says
  std::vector<mc5::Parameter> parameters;
  std::vector<std::string> comments;  // some are empty
  std::size_t lines = 0;              // how many lines of the block it takes
};

Declaration readDeclaration(const BlockSource& source, Problems& problems);

// "E BI", "D KF", "T": kind and type of a parameter, for problems.
std::string typeText(const mc5::Parameter& parameter);
// Word of the parameter list where each parameter begins, 1 = first; a KG takes two words.
std::vector<std::uint32_t> parameterWords(const std::vector<mc5::Parameter>& parameters);
std::uint32_t wordCount(const mc5::Parameter& parameter);

}  // namespace merker::step5
