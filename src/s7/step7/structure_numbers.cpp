#include "step7/structure_numbers.h"

namespace merker::step7 {
namespace {

// Above all numbers of types that have no parts.
constexpr std::uint32_t kFirstWithParts = 0x8000'0000;

bool hasParts(const block::Type& type) { return type.element || !type.members.empty(); }

std::uint32_t simpleNumber(const block::Type& type) {
  return (static_cast<std::uint32_t>(type.code) << 16 | type.length) + 1;
}

}  // namespace

bool StructureNumbers::same(const block::TypePtr& a, const block::TypePtr& b) {
  if (a == b) return true;
  if (!hasParts(*a) && !hasParts(*b)) return block::sameStructure(*a, *b);
  return number(a) == number(b);
}

std::uint32_t StructureNumbers::number(const block::TypePtr& type) {
  if (!hasParts(*type)) return simpleNumber(*type);
  if (const auto known = known_.find(type); known != known_.end()) return known->second;
  Structure structure = structureOf(*type);  // numbers the parts first
  const auto next = kFirstWithParts + static_cast<std::uint32_t>(numbers_.size());
  const std::uint32_t number = numbers_.try_emplace(std::move(structure), next).first->second;
  known_.emplace(type, number);
  return number;
}

// What makes the type, its parts by their numbers; 0 for no element.
StructureNumbers::Structure StructureNumbers::structureOf(const block::Type& type) {
  Structure result{simpleNumber(type), static_cast<std::uint32_t>(type.dimensions.size())};
  for (const block::Dimension& dimension : type.dimensions) {
    result.push_back(static_cast<std::uint32_t>(dimension.low));
    result.push_back(static_cast<std::uint32_t>(dimension.high));
  }
  result.push_back(type.element ? number(type.element) : 0);
  for (const block::Variable& member : type.members) result.push_back(number(member.type));
  return result;
}

}  // namespace merker::step7
