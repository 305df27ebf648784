// Called blocks whose instructions may stand in the regions of their callers.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "lowering/lowering.h"
#include "lowering/translate.h"

namespace merker::translate {

// What is known of such a block before it is translated.
struct Shape {
  const Callee* callee = nullptr;
  std::uint32_t size = 0;  // instructions, with those of the blocks that it calls itself
  // There are ways out of its middle: jumps, or BEB.
  bool branches = false;
  bool keeps = false;                 // it changes what its caller gets back
  std::vector<std::uint8_t> isEntry;  // by instruction: a jump leads there
};

class Shapes {
 public:
  explicit Shapes(const FindCallee& find) : find_(find) {}
  // Of the block that UC or CC at this place calls; null: it must be called.
  const Shape* of(const mc7::Place& call) { return of(call, 0); }

 private:
  const Shape* of(const mc7::Place& call, std::uint32_t depth);
  std::optional<Shape> measure(const Callee& callee, std::uint32_t depth);

  const FindCallee& find_;
  std::map<const Callee*, std::optional<Shape>> known_;
};

bool isCall(mc7::Operation operation);
bool isEnd(mc7::Operation operation);
Lower functionOf(mc7::Operation operation);

}  // namespace merker::translate
