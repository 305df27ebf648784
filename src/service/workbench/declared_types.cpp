#include "workbench/declared_types.h"

#include <algorithm>

#include "base/text.h"
#include "workbench/json.h"

namespace merker::workbench {
namespace {

const block::Type* member(const std::vector<block::Variable>& variables, std::string_view name) {
  const auto at = std::ranges::find_if(
      variables, [name](const block::Variable& one) { return equalsIgnoreCase(one.name, name); });
  return at == variables.end() ? nullptr : at->type.get();
}

}  // namespace

// "list[2].speed": a name, then an index or a member, and so on.
const block::Type* DeclaredTypes::local(std::string_view path) const {
  std::size_t end = std::min(path.find_first_of(".["), path.size());
  const block::Type* type = member(block_->variables, path.substr(0, end));
  for (path.remove_prefix(end); type != nullptr && !path.empty(); path.remove_prefix(end)) {
    const bool index = path.front() == '[';
    end = std::min(index ? path.find(']') : path.find_first_of(".[", 1), path.size());
    if (index)
      type = type->element.get();
    else
      type = member(type->members, path.substr(1, end - 1));
    if (index && end < path.size()) ++end;
  }
  return type;
}

const source::Symbol* DeclaredTypes::symbol(std::string_view operand) const {
  if (operand.size() > 2 && operand.front() == '"' && operand.back() == '"')
    return symbols_->find(operand.substr(1, operand.size() - 2));
  const auto address = source::parseSymbolAddress(operand, nowhere(), symbols_->language());
  return address ? symbols_->findAddress(*address) : nullptr;
}

std::optional<TypeCode> DeclaredTypes::of(std::string_view operand) const {
  std::optional<TypeCode> code;
  if (operand.starts_with('#')) {
    const block::Type* type = block_ == nullptr ? nullptr : local(operand.substr(1));
    if (type != nullptr) code = type->code;
  } else if (symbols_ != nullptr) {
    if (const source::Symbol* known = symbol(operand)) code = known->type;
  }
  return code && isElementary(*code) ? code : std::nullopt;
}

}  // namespace merker::workbench
