// Backwards over a region: what no acting operation and no exit reads is not needed. Comparisons
// whose bit only exits read, condition codes above all, are left to these, and so are words in an
// accumulator.
#include "icode/region.h"

namespace merker::icode {
namespace {

class Marker {
 public:
  explicit Marker(Region& region) : region_(region) {}

  void run() {
    for (Op& op : region_.ops) op.needed = info(op.code).effect == Effect::Acts;
    for (std::size_t i = region_.ops.size(); i-- > 0;)
      if (region_.ops[i].needed) markArguments(region_.ops[i]);
    markLate();
  }

 private:
  void mark(Value value) {
    if (value != kNoValue) region_.ops[value].needed = true;
  }
  static bool canBeLate(Opcode code) {
    return (code >= Opcode::Equal && code <= Opcode::BelowEqual) || code == Opcode::LessReal ||
           code == Opcode::Zext16;
  }
  void markLate() {
    for (Op& op : region_.ops) op.late = op.needed && canBeLate(op.code);
    for (const Op& op : region_.ops) {
      if (!op.needed) continue;
      for (const Value value : {op.a, op.b, op.c})
        if (value != kNoValue) region_.ops[value].late = false;
    }
    for (const ByteWrite& write : region_.bytes) region_.ops[write.value].late = false;
  }
  void markArguments(const Op& op) {
    mark(op.a), mark(op.b), mark(op.c);
    for (const std::uint32_t number : ExitsOf(region_, op)) {
      const Exit& exit = region_.exits[number];
      for (std::uint32_t i = 0; i < exit.states; ++i)
        mark(region_.states[exit.firstState + i].value);
      for (std::uint32_t i = 0; i < exit.bytes; ++i) mark(region_.bytes[exit.firstByte + i].value);
    }
  }
  Region& region_;
};

}  // namespace

void optimise(Region& region) { Marker(region).run(); }

}  // namespace merker::icode
