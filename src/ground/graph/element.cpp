#include "graph/element.h"

#include <algorithm>
#include <charconv>

namespace merker::graph {
namespace {

std::uint32_t number(std::string_view text, std::uint32_t otherwise) {
  std::from_chars(text.data(), text.data() + text.size(), otherwise);
  return otherwise;
}

class PatternReader {
 public:
  explicit PatternReader(Element& element) : element_(element) {}

  void read(std::string_view pattern) {
    while (!pattern.empty()) {
      const std::size_t end = std::min(pattern.find(' '), pattern.size());
      if (end > 0) word(pattern.substr(0, end));
      pattern.remove_prefix(std::min(end + 1, pattern.size()));
    }
  }

 private:
  void word(std::string_view word) {
    if (word[0] == '<')
      return add({ItemKind::Logic, Op::OTHER, pin(word.substr(1), PinKind::Logic)});
    if (word[0] == '>')
      return add({ItemKind::Output, Op::AND, pin(word.substr(1), PinKind::Output)});
    if (word[0] == '[') {
      begin_ = element_.items.size();
      return add({ItemKind::Begin});
    }
    if (word[0] == ']') {
      element_.items[begin_].number = static_cast<std::uint32_t>(element_.items.size() - begin_);
      return add({ItemKind::End, Op::NOP0, 0, number(word.substr(1), 1)});
    }
    statement(word);
  }

  void statement(std::string_view word) {
    const std::size_t mark = std::min(word.find_first_of("$:#"), word.size());
    const Op op = findOp(word.substr(0, mark)).value_or(Op::OTHER);
    if (mark == word.size()) return add({ItemKind::Plain, op});
    const std::string_view rest = word.substr(mark + 1);
    if (word[mark] == '$') return add({ItemKind::Own, op});
    if (word[mark] == '#') return add({ItemKind::Bld, op, 0, number(rest, 0)});
    add({ItemKind::Value, op,
         pin(rest, op == Op::TRANSFER ? PinKind::ValueOut : PinKind::ValueIn)});
  }

  std::size_t pin(std::string_view name, PinKind kind) {
    const std::size_t mark = name.find('/');
    const bool one = mark == std::string_view::npos;
    element_.pins.push_back({name.substr(0, mark), one ? name : name.substr(mark + 1), kind});
    return element_.pins.size() - 1;
  }
  void add(const Item& item) { element_.items.push_back(item); }

  Element& element_;
  std::size_t begin_ = 0;
};

}  // namespace

ElementTable::ElementTable(std::span<const ElementRow> rows) {
  for (const ElementRow& row : rows) {
    Element& element = elements_.emplace_back();
    element.row = row;
    PatternReader(element).read(row.pattern);
  }
}

const Element* ElementTable::find(std::string_view id) const {
  const auto at = std::find_if(elements_.begin(), elements_.end(),
                               [id](const Element& e) { return e.row.id == id; });
  return at == elements_.end() ? nullptr : &*at;
}

const Element& ElementTable::counterpart(const Element& element, bool behindLogic) const {
  if (!isCoil(element)) return element;
  const ElementClass kind = behindLogic ? ElementClass::Coil : ElementClass::RailCoil;
  const auto at = std::find_if(elements_.begin(), elements_.end(), [&](const Element& e) {
    return e.row.kind == kind && e.row.kop == element.row.kop;
  });
  return at == elements_.end() ? element : *at;
}

}  // namespace merker::graph
