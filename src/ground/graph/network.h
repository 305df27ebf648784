// A network of KOP or FUP as trees. There are no coordinates and no free wires anywhere.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/element.h"
#include "graph/statement.h"

namespace merker::graph {

enum class NodeKind : std::uint8_t {
  Series,
  Parallel,
  Xor,
  Contact,      // operand, negated
  Not,          // turns the signal round
  Edge,         // of the signal: memory, falling
  OperandEdge,  // of an operand: operand, memory, falling
  Connector,    // the signal so far, also in `operand`: a flag, or a Wire where the rung branches
  Box           // element: compare, flip-flop, timer, counter, move, call
};

// How a node joins what stands before it.
enum class Join : std::uint8_t { And, Or, Xor };

struct Node;

struct Pin {
  bool open = false;
  std::vector<Node> logic;  // at most one
  Operand operand;
  std::size_t statement = 0;  // that loads or transfers the operand
  bool operator==(const Pin& other) const;
};

struct Node {
  NodeKind kind = NodeKind::Series;
  Join join = Join::And;
  bool bracketed = false, negated = false, falling = false;
  Operand operand, memory;
  std::vector<Node> children;

  const Element* element = nullptr;
  std::vector<Pin> pins;        // as the element's row has them
  bool continues = false;       // something follows its output, or its ENO; drawing: from a branch
  Eno eno = Eno::None;          // how ENO comes about, if something follows it
  std::vector<Node> enable;     // EN, at most one; none: EN is open
  std::vector<Pin> parameters;  // CALL: logic at BOOL parameters with the Wire it goes to
  std::vector<Argument> arguments;  // CALL

  std::size_t first = 0, last = 0;  // its statements: [first, last)
  bool selected = false;            // by the edit that is done
  bool operator==(const Node& other) const;
};

struct Coil {
  const Element* element = nullptr;
  Operand operand;
  std::vector<Operand> values;
  std::size_t first = 0, last = 0;
  bool selected = false;
  bool operator==(const Coil& other) const {
    return element == other.element && operand == other.operand && values == other.values;
  }
};

// From the rail, or from a branch (its logic begins with a Wire), to its coils.
struct Rung {
  std::vector<Node> logic;  // none, or one
  bool straight = false;    // from the branch straight to the coil: BLD 102
  std::vector<Coil> coils;
  bool operator==(const Rung&) const = default;
};

struct Network {
  std::vector<Rung> rungs;
  bool operator==(const Network&) const = default;
};

}  // namespace merker::graph
