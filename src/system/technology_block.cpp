#include "system/technology_block.h"

namespace merker::system {
namespace {

enum { LADDR, CHANNEL };
constexpr std::uint32_t kWrongMode = 0x8001, kNoChannel = 0x8009;

}  // namespace

technology::Channel& channelAt(Arguments& a) {
  return a.counting()->at(a.value(CHANNEL), a.machine().clock);
}

technology::Function* openChannel(Arguments& a, std::size_t jobStat) {
  technology::Counting* counting = a.counting();
  const auto refuse = [&](std::uint32_t code) -> technology::Function* {
    a.set(jobStat, code);
    a.fail();
    return nullptr;
  };
  if (counting == nullptr || !counting->answers(a.value(LADDR)) || !counting->sound())
    return refuse(kWrongMode);
  const std::int32_t channel = a.integer(CHANNEL);
  if (channel < 0 || channel >= static_cast<std::int32_t>(counting->channels()))
    return refuse(kNoChannel);
  technology::Function* function = channelAt(a).function();
  if (function == nullptr) return refuse(kWrongMode);
  counting->changed();  // outputs and interrupts follow at the end of the instruction
  a.machine().interrupt();
  return function;
}

}  // namespace merker::system
