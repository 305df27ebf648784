#include "network/network.h"

#include <algorithm>

#include "base/text.h"
#include "network/member.h"

namespace merker::network {

using controller::Controller;
using controller::Mode;

Network::Network(std::vector<Station> stations, unsigned threads)
    : stations_(std::move(stations)),
      workers_(static_cast<unsigned>(std::min<std::size_t>(threads, stations_.size()))) {
  for (std::size_t i = 0; i < stations_.size(); ++i)
    members_.push_back(std::make_unique<Member>(*this, i));
}

Network::~Network() = default;

Controller& Network::station(std::size_t i) { return *members_[i]; }

Subnet& Network::addSubnet(const Medium& medium, std::string name) {
  return *subnets_.emplace_back(std::make_unique<Subnet>(medium, std::move(name)));
}

Subnet* Network::subnet(std::string_view name) {
  const auto found = std::ranges::find_if(
      subnets_, [&](const auto& one) { return equalsIgnoreCase(one->name(), name); });
  return found == subnets_.end() ? nullptr : found->get();
}

const Network::Place* Network::placeOf(std::size_t station, const Subnet& subnet) const {
  for (const Place& place : places_)
    if (place.station == station && place.subnet == &subnet) return &place;
  return nullptr;
}

std::optional<std::uint8_t> Network::addressOf(std::size_t station, const Subnet& subnet) const {
  const Place* const place = placeOf(station, subnet);
  return place == nullptr ? std::nullopt : std::optional(place->node->address());
}

std::optional<std::size_t> Network::find(std::string_view station) const {
  for (std::size_t i = 0; i < size(); ++i)
    if (equalsIgnoreCase(name(i), station)) return i;
  return std::nullopt;
}

void Network::join(std::size_t i, Subnet& subnet, std::uint8_t address,
                   const GlobalData& globalData) {
  attach(i, subnet, address);
  controller::capability<Connectable>(itself(i))->join(*places_.back().node, globalData);
}

void Network::joinDp(std::size_t i, Subnet& subnet, std::uint8_t address) {
  attach(i, subnet, address);
  controller::capability<Connectable>(itself(i))->joinDp(*places_.back().node);
}

// What the wires show before time begins has arrived when it does.
void Network::wire(std::size_t plants, std::size_t terminals) {
  Subnet& subnet = addSubnet(wires());
  attach(plants, subnet, 1);
  attach(terminals, subnet, 2);
  for (const bool plant : {true, false}) {
    const std::size_t own = plant ? plants : terminals, other = plant ? terminals : plants;
    controller::capability<Connectable>(itself(own))
        ->joinWires(*placeOf(own, subnet)->node, other, plant);
    subnet.carry(Instant{});
  }
}

void Network::attach(std::size_t i, Subnet& subnet, std::uint8_t address) {
  places_.push_back({i, &subnet, &subnet.add(address)});
}

void Network::connect(const Subnet& subnet, const Partner& calling, const Partner& called,
                      ConnectionKind kind) {
  Node& from = *placeOf(calling.station, subnet)->node;
  Node& to = *placeOf(called.station, subnet)->node;
  const std::uint16_t number = ++connections_;
  const auto join = [&](const Partner& one, Node& own, const Node& other, bool active) {
    controller::capability<Connectable>(itself(one.station))
        ->connect({&own, other.address(), number, one.id, active, kind});
  };
  join(calling, from, to, true);
  join(called, to, from, false);
}

// Somebody on it may send.
bool Network::inUse(const Subnet& subnet) const {
  return std::ranges::any_of(places_, [&](const Place& place) {
    return place.subnet == &subnet &&
           controller::capability<Connectable>(*stations_[place.station].plc)->maySend();
  });
}

// What is sent from now on arrives after it at the earliest; where nobody sends, nothing arrives.
Instant Network::windowEnd(Instant wanted) const {
  for (const auto& subnet : subnets_) {
    const Instant reached = now_ + subnet->lookahead();
    if (reached < wanted && inUse(*subnet)) wanted = reached;
  }
  return wanted;
}

// All have moved up to `end`: what they sent before it is known.
void Network::close(Instant end) {
  now_ = std::max(now_, end);
  for (const auto& subnet : subnets_) subnet->carry(now_);
}

void Network::advanceTo(Instant t) {
  while (now_ < t) {
    const Instant end = windowEnd(t);
    workers_.each(size(), [&](std::size_t i) { stations_[i].plc->advanceTo(end); });
    close(end);
  }
}

void Network::othersTo(std::size_t i, Instant end) {
  workers_.each(size(), [&](std::size_t other) {
    if (other != i) stations_[other].plc->advanceTo(end);
  });
  close(end);
}

bool Network::advanceToCheckpoint(std::size_t i, Instant limit) {
  Controller& plc = itself(i);
  while (now_ < limit) {
    const Instant end = windowEnd(limit);
    const bool reached = plc.advanceToCheckpoint(end);
    othersTo(i, reached ? std::min(end, plc.now()) : end);
    if (reached) return true;
  }
  return false;
}

bool Network::settle(std::size_t i, Duration longest) {
  Controller& plc = itself(i);
  const Instant latest = now_ + longest;
  for (;;) {
    const Instant end = windowEnd(latest);
    const bool ended = plc.settle(end - plc.now());
    othersTo(i, ended ? std::min(end, plc.now()) : end);
    if (ended || now_ >= latest) return ended;
  }
}

void Network::advanceCycles(std::size_t i, std::uint64_t count) {
  const Controller& plc = itself(i);
  const auto executes = [&] { return plc.mode() == Mode::Startup || plc.mode() == Mode::Run; };
  for (; count > 0 && executes(); --count) {
    const std::uint64_t before = plc.cycles();
    const Instant latest = plc.now() + Controller::kLongestCycle;
    while (plc.cycles() == before && executes() && plc.now() < latest)
      advanceToCheckpoint(i, latest);
    if (plc.cycles() == before) return;  // STOP, or a startup OB that does not end
  }
}

// Whoever has come to the end of its cycle waits there.
bool Network::settle(Duration longest) {
  const Instant latest = now_ + longest;
  std::vector<char> ended(size());
  const auto all = [&] { return std::ranges::count(ended, 0) == 0; };
  do {
    const Instant end = windowEnd(latest);
    workers_.each(size(), [&](std::size_t i) {
      Controller& plc = itself(i);
      if (ended[i] == 0) ended[i] = plc.settle(end - plc.now()) ? 1 : 0;
    });
    close(end);
  } while (!all() && now_ < latest);
  return all();
}

}  // namespace merker::network
