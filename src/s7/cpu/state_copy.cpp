#include "cpu/state_copy.h"

#include <algorithm>
#include <cstring>

#include "cpu/start_information.h"

namespace merker::cpu {

StateCopy::Difference StateCopy::update(const Machine& m, bool allInputs) {
  part_ = bytes_ = 0;
  found_ = {};
  takeImage(m.areas);
  const std::size_t inputs = m.areas.inputs.size();
  const std::size_t image = std::min<std::size_t>(inputs, m.areas.imageBytes);
  take(m.areas.inputs.data(), image, "PE");
  if (allInputs)
    take(m.areas.inputs.data() + image, inputs - image, "PE", static_cast<std::uint32_t>(image));
  else
    keepPart();
  take(m.areas.outputs.data(), m.areas.outputs.size(), "PA");
  takeTimers(m.timers);
  take(m.counters.data(), m.counters.size() * sizeof(S5Counter), "Z");
  const std::vector<DataBlock>& blocks = m.dataBlocks.all();
  for (std::uint32_t i = 0; i < blocks.size(); ++i)
    if (blocks[i].loaded) take(blocks[i].data.data(), blocks[i].data.size(), "DB", i);
  takeLocalStacks(m);
  if (parts_.size() != part_ && !found_) found_ = {.area = "DB"};
  parts_.resize(part_);
  if (found_.area == "T" || found_.area == "Z") {
    const std::size_t bytes = found_.area == "T" ? sizeof(S5Timer) : sizeof(S5Counter);
    found_ = {found_.area, static_cast<std::uint32_t>(found_.byte / bytes), 0};
  }
  return found_;
}

void StateCopy::takeImage(const Areas& areas) {
  take(areas.image.data(), areas.outputBase, "E");
  take(areas.image.data() + areas.outputBase, areas.flagBase - areas.outputBase, "A");
  take(areas.image.data() + areas.flagBase, areas.image.size() - areas.flagBase, "M");
}

// What stays of one cycle for the temporary variables of the next. The first OB of each cycle finds
// its start information in the first bytes, whatever stood there.
void StateCopy::takeLocalStacks(const Machine& m) {
  constexpr std::size_t kHandedOver = std::tuple_size_v<StartInformation>;
  for (std::uint32_t i = 0; i < m.localStacks.size(); ++i) {
    const std::vector<std::uint8_t>& stack = m.localStacks[i];
    const std::size_t from = i == 0 ? std::min(kHandedOver, stack.size()) : 0;
    take(stack.data() + from, stack.size() - from, "L");
  }
}

void StateCopy::takeTimers(const std::vector<S5Timer>& timers) {
  if (!take(timers.data(), timers.size() * sizeof(S5Timer), "T")) return;
  startedTimers_.clear();
  for (std::uint32_t i = 0; i < timers.size(); ++i)
    if (timers[i].started) startedTimers_.push_back(i);
}

void StateCopy::keepPart() {
  if (part_ == parts_.size()) parts_.emplace_back();
  ++part_;
}

// Whether it was something else, or of another length.
bool StateCopy::take(const void* data, std::size_t bytes, std::string_view area,
                     std::uint32_t number) {
  if (part_ == parts_.size()) parts_.emplace_back();
  std::vector<std::uint8_t>& copy = parts_[part_++];
  bytes_ += bytes;
  if (copy.size() == bytes && (bytes == 0 || std::memcmp(copy.data(), data, bytes) == 0))
    return false;
  const auto* from = static_cast<const std::uint8_t*>(data);
  const bool fits = copy.size() == bytes;
  if (!found_) {
    const auto at = fits ? std::mismatch(copy.begin(), copy.end(), from).first : copy.begin();
    found_ = {area, number, static_cast<std::uint32_t>(at - copy.begin())};
  }
  copy.assign(from, from + bytes);
  return true;
}

}  // namespace merker::cpu
