#include "icode/region.h"

namespace merker::icode {
namespace {

constexpr OpcodeInfo kInfos[] = {
#define ICODE(id, text, result, arguments, effect) \
  {text, Result::result, arguments, Effect::effect},
#include "icode/icode.inc"
#undef ICODE
};

}  // namespace

const OpcodeInfo& info(Opcode opcode) { return kInfos[static_cast<std::size_t>(opcode)]; }

}  // namespace merker::icode
