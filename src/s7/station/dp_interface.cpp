#include "station/dp_interface.h"

#include <algorithm>
#include <utility>

#include "io/slave.h"

namespace merker::station {
namespace {

// The first byte of a telegram; then the bytes of all outputs.
constexpr std::uint8_t kThere = 1, kExecutes = 2;

}  // namespace

DpInterface::DpInterface(io::Rack& rack, const profibus::Exchange& exchange)
    : rack_(rack), exchange_(exchange) {
  const io::Configuration& configuration = rack.configuration();
  if (configuration.dp) {
    const std::vector<io::Slave>& slaves = configuration.dp->slaves;
    for (std::size_t i = 0; i < slaves.size(); ++i)
      if (slaves[i].intelligent) add(slaves[i].address, slaves[i], i);
  }
  if (configuration.ownSlave)
    add(configuration.ownSlave->master, configuration.ownSlave->self, std::nullopt);
}

void DpInterface::add(std::uint8_t address, const io::Slave& slave,
                      std::optional<std::size_t> turn) {
  Partner partner;
  partner.address = address;
  partner.slave = turn;
  const std::vector<io::Module>& modules = rack_.configuration().modules;
  for (std::uint32_t i = 0; i < modules.size(); ++i) {
    if (modules[i].rack != io::kSlaveRack + slave.address) continue;
    if (io::isHead(*modules[i].type))
      partner.head = i;
    else
      (modules[i].inputStart ? partner.inputs : partner.outputs).push_back(i);
  }
  partners_.push_back(std::move(partner));
  partners_.back().said = telegram(partners_.back());
}

Instant DpInterface::next() const {
  if (node_ == nullptr) return Instant::never();
  Instant first = node_->next();
  for (const Partner& partner : partners_) first = std::min(first, partner.due);
  return first;
}

void DpInterface::hear(Instant now) {
  if (node_ == nullptr) return;
  while (const auto telegram = node_->receive(now))
    for (Partner& partner : partners_)
      if (partner.address == telegram->from) partner.heard = telegram->data, take(partner);
}

// Who is gone has failed (OB 86); who does not execute its program has a fault (OB 82). Over a
// broken line the master hears nothing, and the last news when it is mended.
void DpInterface::take(Partner& partner) {
  if (partner.heard.empty() || (partner.slave && !rack_.lineReaches(partner.head))) return;
  const std::vector<std::uint8_t> telegram = std::exchange(partner.heard, {});
  rack_.fault(partner.head, io::FaultKind::RackPower, std::nullopt, (telegram[0] & kThere) == 0);
  auto at = telegram.begin() + 1;
  for (const std::uint32_t input : partner.inputs) {
    const std::uint32_t count = rack_.configuration().modules[input].type->inputBytes;
    rack_.answer(input, {at, at + count});
    at += count;
  }
  const bool stopped = (telegram[0] & kExecutes) == 0;
  if ((telegram[0] & kThere) == 0 || stopped == partner.stopped) return;
  partner.stopped = stopped;
  rack_.partnerStops(partner.head, stopped);
}

// A slave that is not reached hears of it as well: it sees no master.
std::vector<std::uint8_t> DpInterface::telegram(const Partner& partner) const {
  const bool there = supplied_ && (!partner.slave || rack_.lineReaches(partner.head));
  std::vector<std::uint8_t> bytes{
      static_cast<std::uint8_t>((there ? kThere : 0) | (executes_ ? kExecutes : 0))};
  std::size_t inputs = 0;
  for (const std::uint32_t output : partner.outputs) {
    const io::Module& module = rack_.configuration().modules[output];
    for (std::uint32_t i = 0; i < module.type->outputBytes; ++i)
      bytes.push_back(there ? rack_.sent(*module.outputStart + i) : std::uint8_t{0});
  }
  for (const std::uint32_t input : partner.inputs)
    inputs += rack_.configuration().modules[input].type->inputBytes;
  bytes.resize(bytes.size() + inputs);  // as long as a turn: outputs and inputs
  return bytes;
}

void DpInterface::say(Partner& partner, Instant now) {
  partner.due = Instant::never();
  std::vector<std::uint8_t> bytes = telegram(partner);
  if (bytes == partner.said) return;
  partner.said = bytes;
  node_->send(now, partner.address, std::move(bytes));
}

void DpInterface::changed(Instant now) {
  if (node_ == nullptr) return;
  for (Partner& partner : partners_) {
    take(partner);
    say(partner, now);
  }
}

void DpInterface::advance(Instant now) {
  for (Partner& partner : partners_)
    if (partner.due <= now) say(partner, now);
}

// The master's outputs leave it when the slave's turn begins.
void DpInterface::written(std::uint32_t first, std::uint32_t count, Instant now) {
  if (node_ == nullptr) return;
  for (Partner& partner : partners_) {
    const bool own = std::ranges::any_of(partner.outputs, [&](std::uint32_t output) {
      const io::Module& module = rack_.configuration().modules[output];
      return first <= module.outputEnd() && *module.outputStart < first + count;
    });
    if (!own) continue;
    if (!partner.slave)
      say(partner, now);
    else if (partner.due == Instant::never())
      partner.due = exchange_.turnBegins(*partner.slave, now);
  }
}

// With power again it starts at this instant, or stays in STOP.
void DpInterface::supply(bool on, Instant now) {
  supplied_ = on;
  if (!on) return changed(now);
  for (Partner& partner : partners_) partner.due = now + Duration{1};
}

void DpInterface::execute(bool does, bool powered, Instant now) {
  executes_ = does;
  if (powered) changed(now);
}

}  // namespace merker::station
