// Which types are the same throughout: each structure is walked once and gets a number, so that a
// CALL compares two numbers however large the types of its parameters are.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "block/type.h"

namespace merker::step7 {

class StructureNumbers {
 public:
  // As block::sameStructure.
  bool same(const block::TypePtr& a, const block::TypePtr& b);

 private:
  using Structure = std::vector<std::uint32_t>;

  std::uint32_t number(const block::TypePtr& type);
  Structure structureOf(const block::Type& type);

  std::map<block::TypePtr, std::uint32_t> known_;
  std::map<Structure, std::uint32_t> numbers_;
};

}  // namespace merker::step7
