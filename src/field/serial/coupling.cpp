#include "serial/coupling.h"

#include <algorithm>
#include <utility>

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
  build(Instant{});
  interface().start(Instant{});
  line_->advance(Instant{});
}

// A line without pacing: a character takes about a microsecond, the times of the drivers are those
// of the rate that is set (PTP-LINE-07).
Settings Coupling::onWire(Settings settings) const {
  constexpr std::uint32_t kUnlimited = 10'000'000;
  if (!owner().parameters_.paced) settings.baud = kUnlimited;
  return settings;
}

// Without supply it drives nothing.
Settings Coupling::wired() const {
  Settings own = onWire(parameters_.line);
  if (!powered_ && own.mode != Mode::TwoWire) own.mode = Mode::MultipointSlave;
  return own;
}

// A line with the present settings of both ends; what was on it is lost. A BREAK goes on, except at
// an end that begins anew.
void Coupling::connect(Instant now, bool anew) {
  std::array<bool, 2> broken{};
  if (owner().line_)
    for (std::size_t i = 0; i < broken.size(); ++i)
      broken[i] = line().port(i).receiver().interrupted() && !(anew && i == portOf(End::Cpu));
  owner().build(now);
  for (std::size_t i = 0; i < broken.size(); ++i)
    if (broken[i]) line().port(i).receiver().interrupt(now);
}

void Coupling::build(Instant now) {
  line_ = std::make_unique<Line>(parameters_.line.mode == Mode::TwoWire);
  line_->join(driver(), wired());
  if (joined())
    line_->join(other_->driver(), other_->wired());
  else
    line_->join(partner_, onWire(partnerSettings_));
  for (std::size_t i = 0; i < wiring_.size(); ++i) {
    if (wiring_[i].cut) line_->cut(i, true, now);
    if (wiring_[i].swapped) line_->swapPolarity(i, true, now);
    line_->port(i).listen([this](const Sighting& sighting) {
      see(sighting);
      if (joined()) other_->see(sighting);
    });
  }
}

void Coupling::join(Coupling& other, Follow follow, Follow followed) {
  other_ = &other;
  follow_ = std::move(follow);
  other.other_ = this;
  other.follow_ = std::move(followed);
  other.ownsLine_ = false;
  for (Coupling* end : {this, &other})
    end->operation_ = std::make_unique<Operation>(end->parameters_);
  build(Instant{});
  for (Coupling* end : {this, &other}) end->sightings_.clear(), end->seen_ = 0;
  for (Coupling* end : {this, &other}) end->interface().start(Instant{});
  line_->advance(Instant{});
}

// For each station its own port is 0.
void Coupling::see(Sighting sighting) {
  ++seen_;
  if (!ownsLine_) sighting.port = 1 - sighting.port;
  sightings_.push_back(sighting);
  if (sightings_.size() > kMostSightings) sightings_.pop_front();
}

Instant Coupling::next() const {
  if (!parameters_.diagnosticInterrupt || !powered_) return Instant::never();
  return operation_->interface.wireBreakPending() ? Instant{} : owner().line_->next();
}

void Coupling::advance(Instant now) {
  bool& following = owner().following_;
  if (joined() && !std::exchange(following, true)) {
    follow_(now);
    following = false;
  }
  line().advance(now);
}

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
  connect(now, true);
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
  advance(now);
  owner().wiring_[portOf(end)].cut = open;
  line().cut(portOf(end), open, now);
  advance(now);
}

void Coupling::swapPolarity(End end, bool swapped, Instant now) {
  advance(now);
  owner().wiring_[portOf(end)].swapped = swapped;
  line().swapPolarity(portOf(end), swapped, now);
  advance(now);
}

void Coupling::noise(End end, std::uint16_t bits, Instant now) {
  const Settings& far = joined() ? other_->parameters_.line : partnerSettings_;
  const Settings settings = onWire(end == End::Cpu ? parameters_.line : far);
  advance(now);
  line().noise(portOf(end), bits, static_cast<std::uint8_t>(settings.frame.bits()), settings.baud,
               now);
  advance(now);
}

void Coupling::disturb(End end, std::uint64_t after, const Fault& fault) {
  Port& port = line().port(portOf(end));
  port.disturb(port.characters() + after, fault);
}

}  // namespace merker::serial
