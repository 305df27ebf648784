// Constants: any text is read or refused; what was read is written so that it reads back.
#include "address/constant.h"
#include "harness.h"

using namespace merker;

namespace {

void writeAndRead(const Constant& constant) {
  for (const Mnemonics mnemonics : {Mnemonics::German, Mnemonics::International}) {
    const auto again = parseConstant(formatConstant(constant, mnemonics), {});
    fuzz::require(again && again->bits == constant.bits, "a constant reads back to its bits");
    (void)formatValue(naturalType(constant), constant.bits, mnemonics);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text(data, size);
  if (const auto constant = parseConstant(text, {})) writeAndRead(*constant);
  if (const auto characters = parseCharacters(text, {})) {
    const auto again = parseCharacters(formatCharacters(*characters), {});
    fuzz::require(again && *again == *characters, "characters read back to their bytes");
  }
  if (const auto clock = parseDateAndTime(text, {})) {
    const auto again = parseDateAndTime(formatDateAndTime(*clock), {});
    fuzz::require(again && *again == *clock, "a DATE_AND_TIME reads back to its digits");
  }
  return 0;
}
