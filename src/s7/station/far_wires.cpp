#include "station/far_wires.h"

#include <algorithm>
#include <cstring>

namespace merker::station {
namespace {

// Long before time begins: any input delay is over when it does.
constexpr Instant kBefore = Instant{} - Duration::seconds(1);

// The number of the wire and what its other end shows, within one process.
struct Change {
  std::uint32_t number;
  double value;
};

std::vector<std::uint8_t> pack(const Change& change) {
  std::vector<std::uint8_t> bytes(sizeof change.number + sizeof change.value);
  std::memcpy(bytes.data(), &change.number, sizeof change.number);
  std::memcpy(bytes.data() + sizeof change.number, &change.value, sizeof change.value);
  return bytes;
}

Change unpack(const std::vector<std::uint8_t>& bytes) {
  Change change{};
  std::memcpy(&change.number, bytes.data(), sizeof change.number);
  std::memcpy(&change.value, bytes.data() + sizeof change.number, sizeof change.value);
  return change;
}

// The one side of the wires has this address, the other one the other.
std::uint8_t otherAddress(const network::Node& node) { return node.address() == 1 ? 2 : 1; }

}  // namespace

std::vector<FarWires::End> FarWires::endsOfPlants(std::size_t partner) const {
  const plant::Configuration& plants = plants_.configuration();
  std::vector<End> ends;
  for (std::uint32_t i = 0; i < plants.far.size(); ++i) {
    const plant::FarWire& far = plants.far[i];
    if (far.station != partner) continue;
    const plant::PlantSettings& plant = plants.plants[far.plant];
    const plant::Signal& signal = plant.kind->signals[plant.wires[far.wire].signal];
    ends.push_back({i, true, {}, signal.side == plant::Signal::Side::Output});
  }
  return ends;
}

std::vector<FarWires::End> FarWires::endsOfTerminals(std::size_t partner) const {
  std::vector<End> ends;
  for (const plant::LentTerminal& one : plants_.configuration().lent)
    if (one.station == partner)
      ends.push_back({one.number, false, one.terminal, io::isOutput(one.terminal.side)});
  return ends;
}

void FarWires::join(network::Node& node, std::size_t partner, bool plant) {
  bundles_.push_back({&node, plant ? endsOfPlants(partner) : endsOfTerminals(partner)});
  tell(bundles_.back(), kBefore);
  hear(Instant{});
}

double FarWires::shown(const End& end) const {
  if (end.plant) return plants_.shows(end.number);
  return isDigital(end.terminal.side) ? double(rack_.level(end.terminal))
                                      : rack_.amount(end.terminal);
}

void FarWires::take(const End& end, double value, Instant at) {
  if (end.plant) return plants_.tell(end.number, value);
  // Conversions that have ended measured what was there before; each new amount begins another one.
  rack_.advance(at);
  if (isDigital(end.terminal.side))
    rack_.setLevel(end.terminal, value != 0, at);
  else
    rack_.setAmount(end.terminal, value, at);
}

Instant FarWires::next() const {
  Instant first = Instant::never();
  for (const Bundle& bundle : bundles_) first = std::min(first, bundle.node->next());
  return first;
}

void FarWires::hear(Instant now) {
  for (Bundle& bundle : bundles_)
    while (const auto telegram = bundle.node->receive(now)) {
      const Change change = unpack(telegram->data);
      const Instant at = telegram->at <= Instant{} ? kBefore : now;
      for (const End& end : bundle.ends)
        if (end.number == change.number) take(end, change.value, at);
    }
}

void FarWires::tell(Bundle& bundle, Instant now) {
  for (End& end : bundle.ends) {
    if (!end.tells) continue;
    const double value = shown(end);
    if (value == end.told) continue;
    end.told = value;
    bundle.node->send(now, otherAddress(*bundle.node), pack({end.number, value}));
  }
}

void FarWires::look(Instant now) {
  for (Bundle& bundle : bundles_) tell(bundle, now);
}

}  // namespace merker::station
