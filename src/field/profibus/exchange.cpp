#include "profibus/exchange.h"

#include <algorithm>

namespace merker::profibus {
namespace {

void own(std::vector<std::uint8_t>& owners, const io::Bytes& bytes, std::size_t slave) {
  for (std::uint32_t i = bytes.first; i < bytes.first + bytes.count && i < owners.size(); ++i)
    owners[i] = static_cast<std::uint8_t>(slave);
}

}  // namespace

Exchange::Exchange(io::Rack& rack) : rack_(rack) {
  if (!rack.configuration().dp) return;
  const std::size_t bytes = rack.configuration().model->peripheralBytes;
  inputOwners_.assign(bytes, kNobody);
  outputOwners_.assign(bytes, kNobody);
  staged_.assign(bytes, 0);
  cycle_ = busCycle(master());
  for (const io::Slave& slave : master().slaves) {
    Turn turn;
    for (const io::Module& module : slave.modules) {
      if (module.inputStart) turn.inputs.push_back({*module.inputStart, module.type->inputBytes});
      if (module.outputStart && !slave.intelligent)  // these leave as telegrams of the station
        turn.outputs.push_back({*module.outputStart, module.type->outputBytes});
    }
    for (const io::Bytes& range : turn.inputs) own(inputOwners_, range, slaves_.size());
    for (const io::Bytes& range : turn.outputs) own(outputOwners_, range, slaves_.size());
    slaves_.push_back(std::move(turn));
  }
}

// In the first cycle that has it after `now`.
Instant Exchange::inGrid(Duration first, Instant now) const {
  const std::int64_t passed = now.ns - first.ns;
  const std::int64_t cycles = passed < 0 ? 0 : passed / cycle_.length.ns + 1;
  return Instant{first.ns + cycles * cycle_.length.ns};
}

void Exchange::require(std::size_t slave, Instant now) {
  Turn& turn = slaves_[slave];
  if (turn.due != Instant::never()) return;
  turn.due = turnAfter(slave, now);
  next_ = std::min(next_, turn.due);
}

void Exchange::changed(const std::vector<std::uint8_t>& owners, std::uint32_t byte, Instant now) {
  const std::uint8_t owner = ownerOf(owners, byte);
  if (owner != kNobody) require(owner, now);
}

void Exchange::written(std::uint32_t byte, std::uint8_t value, Instant now) {
  if (staged_[byte] == value) return;
  staged_[byte] = value;
  changed(outputOwners_, byte, now);
}

void Exchange::exchange(Turn& turn, std::vector<io::Bytes>& seen) {
  if (!turn.synced || turn.syncNow)
    for (const io::Bytes& range : turn.outputs)
      rack_.written(range.first, &staged_[range.first], range.count);
  if (!turn.frozen || turn.freezeNow)
    seen.insert(seen.end(), turn.inputs.begin(), turn.inputs.end());
  turn.syncNow = turn.freezeNow = false;
  turn.due = Instant::never();
}

// In the order of time; a slave whose outputs lead back to its inputs shows them in its next turn.
std::vector<io::Bytes> Exchange::advance(Instant now) {
  std::vector<io::Bytes> seen;
  if (next_ > now) return seen;
  next_ = Instant::never();
  for (Turn& turn : slaves_) {
    if (turn.due <= now) exchange(turn, seen);
    next_ = std::min(next_, turn.due);
  }
  return seen;
}

// SYNC and FREEZE take what is there at their turn, and hold it until the next one or UNSYNC and
// UNFREEZE.
void Exchange::control(std::uint8_t groups, std::uint8_t commands, Instant now) {
  const auto has = [&](Control one) { return (commands & static_cast<std::uint8_t>(one)) != 0; };
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const io::Slave& slave = master().slaves[i];
    if ((slave.groups & groups) == 0) continue;
    Turn& turn = slaves_[i];
    if (has(Control::Sync) && slave.sync) turn.synced = turn.syncNow = true;
    if (has(Control::Freeze) && slave.freeze) turn.frozen = turn.freezeNow = true;
    if (has(Control::Unsync)) turn.synced = false;
    if (has(Control::Unfreeze)) turn.frozen = false;
    require(i, now);
  }
}

}  // namespace merker::profibus
