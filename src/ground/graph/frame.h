// A box with its pins, as both languages draw it.
#pragma once

#include <optional>

#include "graph/picture.h"

namespace merker::graph {

struct FramePin {
  std::string name = {}, text = {};   // text: the operand at the pin; empty: open
  std::optional<Picture> logic = {};  // what comes in, drawn to the left of the box
  bool negated = false, fromRail = false;
  int field = kNoPin;                     // where its operand, or logic, is put
  bool value = false;                     // no signal
  Flows flow = {};                        // its signal, as the box gets it
  Flows before = {};                      // of its operand, if a circle turns it round
  Selection of = {};                      // whose operand the text is; none: of the box, at `field`
  std::optional<std::size_t> moved = {};  // the statement that loads or transfers the operand
};

struct FrameText {
  std::string above, title;  // the operand above it, its name inside
  std::vector<FramePin> left,
      right;             // left[0]: where the signal comes in, right[0]: where it goes out
  bool outLast = false;  // the output is at the last input: gates
  bool hasOut = true;
  int blank = 0;           // columns left of operands that stay free
  bool ownInside = false;  // its title is its operand: the block of a CALL
  std::string whole = {};  // its operand, if one part of it is above and one inside
  std::size_t statement = 0;
  Selection of = {};
  Flows flow = {};  // behind it
};

Picture frame(const FrameText& text);

}  // namespace merker::graph
