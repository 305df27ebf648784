// The networks of a compiled program as pictures: KOP, FUP, or AWL where they have none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "address/area.h"
#include "compilation/build.h"
#include "graph/network.h"
#include "graph/picture.h"
#include "graph/reason.h"
#include "graph/rules.h"
#include "graph/style.h"

namespace merker::diagram {

enum class View : std::uint8_t { Kop, Fup, Awl };

struct NetworkDiagram {
  std::size_t number = 1;  // in its block
  std::string title;
  std::string label;                        // where another network jumps to it
  std::optional<graph::Network> network;    // none: it stays AWL
  const graph::Rules* rules = nullptr;      // of its family
  graph::Refusal refusal;                   // then the reason
  std::vector<std::string> statements;      // "U     E 0.0", one for each statement of `graph`
  Mnemonics mnemonics = Mnemonics::German;  // of all of it
};

struct BlockDiagram {
  std::string name, symbol;  // "FB 1"
  std::vector<NetworkDiagram> networks;
};

struct Options {
  std::optional<Mnemonics> mnemonics;  // STEP 7; nothing: those of each text
  bool symbols = false;                // operands by their symbols, where they have one
};
// All code blocks in their order.
std::vector<BlockDiagram> diagrams(const compilation::Build& build, const Options& options);

// A network as text. What KOP cannot draw is FUP, what no text can hold stays AWL.
struct Shown {
  View view = View::Awl;
  std::vector<std::string> lines;
  std::string
      why;  // it is AWL: "statement 2 (TAK): KOP and FUP have no element for this operation"
};
Shown asText(const NetworkDiagram& network, View wanted);

// KOP and FUP below each other, with their titles, as one picture.
graph::Picture drawAll(const std::vector<BlockDiagram>& blocks, View view);

}  // namespace merker::diagram
