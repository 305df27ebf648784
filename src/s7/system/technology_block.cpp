#include "system/technology_block.h"

namespace merker::system {

std::uint32_t openChannel(Arguments& a, std::uint32_t address, std::int32_t channel) {
  technology::Counting* counting = a.counting();
  if (counting == nullptr || !counting->answers(address) || !counting->sound()) return kWrongMode;
  if (channel < 0 || channel >= static_cast<std::int32_t>(counting->channels())) return kNoChannel;
  const auto number = static_cast<std::uint32_t>(channel);
  if (counting->at(number, a.machine().clock).function() == nullptr) return kWrongMode;
  return 0;
}

void act(Arguments& a) {
  a.counting()->changed();
  a.machine().interrupt();
}

}  // namespace merker::system
