// Backwards over a region: what no acting operation and no exit reads is not needed.
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
  }

 private:
  void mark(Value value) {
    if (value != kNoValue) region_.ops[value].needed = true;
  }
  void markArguments(const Op& op) {
    mark(op.a), mark(op.b), mark(op.c);
    if (op.code < Opcode::Guard) return;
    const Exit& exit = region_.exits[op.number];
    for (std::uint32_t i = 0; i < exit.states; ++i) mark(region_.states[exit.firstState + i].value);
    for (std::uint32_t i = 0; i < exit.bytes; ++i) mark(region_.bytes[exit.firstByte + i].value);
  }
  Region& region_;
};

}  // namespace

void optimise(Region& region) { Marker(region).run(); }

}  // namespace merker::icode
