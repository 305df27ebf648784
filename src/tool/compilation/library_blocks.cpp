#include "compilation/library_blocks.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "base/text.h"

namespace merker::compilation {
namespace {

// FAMILY of the library's blocks, whichever way it is written: CP300, CP_300.
constexpr std::string_view kCpFamily = "CP300";

bool isOfCpFamily(const block::Block& block) {
  std::string family = upper(block.attributes.family);
  std::erase_if(family, [](unsigned char c) { return std::isalnum(c) == 0; });
  return family == kCpFamily;
}

// What a caller passes. Static data behind it do not matter: an instance may be longer.
std::vector<const block::Variable*> passed(const block::Block& block) {
  using enum block::Section;
  std::vector<const block::Variable*> list;
  for (const block::Variable& v : block.variables)
    if (v.section == Input || v.section == Output || v.section == InOut || v.section == Return)
      list.push_back(&v);
  return list;
}

bool takesTheSame(const block::Block& a, const block::Block& b) {
  return std::ranges::equal(passed(a), passed(b), [](const auto* x, const auto* y) {
    return x->section == y->section && block::sameStructure(*x->type, *y->type);
  });
}

Position beginOf(const block::Block& block) {
  if (block.lines.empty()) return {block.file};
  return {block.file, block.lines.front().line, block.lines.front().column};
}

}  // namespace

void preferLibraryBlocks(const block::Program& library, block::Program& program,
                         Problems& problems) {
  for (const auto& [id, known] : library) {
    const auto own = program.find(id);
    if (own == program.end() || !isOfCpFamily(known) || !isOfCpFamily(own->second)) continue;
    if (!equalsIgnoreCase(own->second.attributes.name, known.attributes.name)) continue;
    if (!takesTheSame(own->second, known)) continue;
    problems.add(ProblemCode::P0526, beginOf(own->second), toString(id), known.attributes.name);
    program.erase(own);
  }
}

}  // namespace merker::compilation
