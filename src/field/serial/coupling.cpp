#include "serial/coupling.h"

#include <algorithm>

namespace merker::serial {
namespace {

// As the CPU is set, from the other side.
Settings opposite(Settings settings) {
  if (settings.mode == Mode::MultipointMaster) settings.mode = Mode::MultipointSlave;
  settings.preset = settings.mode == Mode::PointToPoint ? Preset::Break : Preset::Idle;
  return settings;
}

}  // namespace

Coupling::Blocks::Blocks(Interface& interface)
    : send(interface),
      receive(interface),
      clear(interface),
      sendLink(interface, false),
      fetchLink(interface, true),
      serve(interface) {}

void Coupling::Blocks::start() {
  send.start();
  receive.start();
  clear.start();
  sendLink.start();
  fetchLink.start();
  serve.start();
  syncBlock = 0;
}

Coupling::Coupling(const Parameters& parameters)
    : parameters_(parameters),
      partnerSettings_(opposite(parameters.line)),
      operation_(std::make_unique<Operation>(parameters)) {
  connect(Instant{});
  interface().start(Instant{});
  line_->advance(Instant{});
}

// A line with the present settings of both ends; what was on it is lost.
void Coupling::connect(Instant now) {
  Settings own = parameters_.line;
  if (!powered_ && own.mode != Mode::TwoWire) own.mode = Mode::MultipointSlave;  // drives nothing
  line_ = std::make_unique<Line>(own.mode == Mode::TwoWire);
  Driver& driver = powered_ ? static_cast<Driver&>(interface()) : silence_;
  line_->join(driver, own);
  line_->join(partner_, partnerSettings_);
  for (std::size_t i = 0; i < wiring_.size(); ++i) {
    if (wiring_[i].cut) line_->cut(i, true, now);
    if (wiring_[i].swapped) line_->swapPolarity(i, true, now);
    line_->port(i).listen([this](const Sighting& sighting) { see(sighting); });
  }
}

void Coupling::see(const Sighting& sighting) {
  ++seen_;
  sightings_.push_back(sighting);
  if (sightings_.size() > kMostSightings) sightings_.pop_front();
}

Instant Coupling::next() const {
  if (!parameters_.diagnosticInterrupt || !powered_) return Instant::never();
  return operation_->interface.wireBreakPending() ? Instant{} : line_->next();
}

void Coupling::advance(Instant now) { line_->advance(now); }

void Coupling::cpuStarted(Instant now) {
  advance(now);
  interface().cpuStarted();
  blocks().start();
  advance(now);
}

void Coupling::cpuStopped(Instant now) {
  advance(now);
  interface().cpuStopped();
  advance(now);
}

// What the interface held is lost with the supply; with it the driver starts anew.
void Coupling::supply(bool on, Instant now) {
  if (on == powered_) return;
  advance(now);
  powered_ = on;
  operation_ = std::make_unique<Operation>(parameters_);
  connect(now);
  if (on) interface().start(now);
  advance(now);
}

void Coupling::setPartner(const Settings& settings, Instant now) {
  advance(now);
  partnerSettings_ = settings;
  connect(now);
  advance(now);
}

void Coupling::cut(End end, bool open, Instant now) {
  wiring_[portOf(end)].cut = open;
  line_->cut(portOf(end), open, now);
  advance(now);
}

void Coupling::swapPolarity(End end, bool swapped, Instant now) {
  wiring_[portOf(end)].swapped = swapped;
  line_->swapPolarity(portOf(end), swapped, now);
  advance(now);
}

void Coupling::noise(End end, std::uint16_t bits, Instant now) {
  const Settings& settings = end == End::Cpu ? parameters_.line : partnerSettings_;
  advance(now);
  line_->noise(portOf(end), bits, static_cast<std::uint8_t>(settings.frame.bits()), settings.baud,
               now);
  advance(now);
}

void Coupling::disturb(End end, std::uint64_t after, const Fault& fault) {
  Port& port = line_->port(portOf(end));
  port.disturb(port.characters() + after, fault);
}

}  // namespace merker::serial
