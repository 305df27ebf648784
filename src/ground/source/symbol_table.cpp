#include "source/symbol_table.h"

#include "base/text.h"

namespace merker::source {

bool SymbolTable::add(Symbol symbol) {
  const bool isNew = byName_.emplace(upper(symbol.name), list_.size()).second;
  if (!isNew) return false;
  byAddress_.emplace(symbol.address, list_.size());
  if (language_ == Language::Step5 && symbol.address.area == Area::Peripheral) {
    SymbolAddress written = symbol.address;
    written.peripheralOutput = true;
    byAddress_.emplace(written, list_.size());
  }
  list_.push_back(std::move(symbol));
  return true;
}

const Symbol* SymbolTable::find(std::string_view name) const {
  const auto found = byName_.find(upper(name));
  return found == byName_.end() ? nullptr : &list_[found->second];
}

const Symbol* SymbolTable::findAddress(const SymbolAddress& address) const {
  const auto found = byAddress_.find(address);
  return found == byAddress_.end() ? nullptr : &list_[found->second];
}

}  // namespace merker::source
