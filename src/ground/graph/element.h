// The elements that a network is drawn of, one row each. Everything about an element comes from its
// row: how it is recognised and written, its pins, its names, what it does in words.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "graph/statement.h"

namespace merker::graph {

enum class ElementClass : std::uint8_t {
  Compare,  // two values, the result is the signal
  Box,      // logic at its pins, the signal goes on behind it: flip-flops, timers, counters
  Move,     // works on values, with EN and ENO
  Call,     // a block with its parameters, with EN and ENO
  Coil,     // ends a rung
  RailCoil  // stands alone at the rail: an unconditional jump, OPN
};

// How ENO comes about, between the work of a box and its end.
enum class Eno : std::uint8_t { None, Always, Overflow };

enum class PinKind : std::uint8_t { Logic, ValueIn, ValueOut, Output };

struct PinRow {
  std::string_view name, english;
  PinKind kind = PinKind::Logic;
};

// A pattern is words, one after the other:
//   <S/X      logic of pin S, in English X   SET_BIT$   a statement with the operand of the element
//   LOAD:TW   a statement with the value of pin TW      ADD_I   a statement without operand
//   [ .. ]n   may be left out; n statements NOP 0 stand for it (1 if not said)
//   >Q        the output: AND$ if something follows it, else NOP 0
//   BLD#101   the BLD of this number
enum class ItemKind : std::uint8_t { Logic, Own, Value, Plain, Bld, Begin, End, Output };

struct Item {
  ItemKind kind = ItemKind::Plain;
  Op op = Op::OTHER;
  std::size_t pin = 0;       // Logic, Value, Output: number of the pin
  std::uint32_t number = 0;  // Bld; End: statements NOP 0; Begin: items up to End
};

struct ElementRow {
  std::string_view id, kop, kopEnglish, fup, fupEnglish;
  ElementClass kind;
  Eno eno;
  std::string_view pattern;
  std::string_view say, sayEnglish;  // a coil: {0} its operand, {1} the logic, {2} its value
};

struct Element {
  ElementRow row;
  std::vector<PinRow> pins;
  std::vector<Item> items;
};

inline bool isCoil(const Element& element) {
  return element.row.kind == ElementClass::Coil || element.row.kind == ElementClass::RailCoil;
}

// The elements of a family, their patterns taken apart, in the order in which they are tried.
class ElementTable {
 public:
  explicit ElementTable(std::span<const ElementRow> rows);
  std::span<const Element> elements() const { return elements_; }
  const Element* find(std::string_view id) const;
  // A coil has the name of one at the rail: JMP is conditional behind logic, else unconditional.
  // The one of them behind logic, or at the rail; any other is its own counterpart.
  const Element& counterpart(const Element& element, bool behindLogic) const;

 private:
  std::vector<Element> elements_;
};

}  // namespace merker::graph
