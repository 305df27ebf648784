#include "scenario/steps/line_fault.h"

#include <algorithm>

#include "base/text.h"
#include "network/member.h"
#include "scenario/duration.h"

namespace merker::simulator::steps {
namespace {

network::Member& memberOf(StepRun& run) { return dynamic_cast<network::Member&>(run.plc()); }

const StationBinding* findStation(const StepBinding& binding, std::string_view name) {
  const auto found = std::ranges::find_if(*binding.stations, [&](const StationBinding& one) {
    return equalsIgnoreCase(one.name, name);
  });
  return found == binding.stations->end() ? nullptr : &*found;
}

bool isOn(const StationBinding& station, std::string_view subnet) {
  return std::ranges::any_of(station.subnets,
                             [&](const auto& one) { return equalsIgnoreCase(one, subnet); });
}

bool endsHere(const StepLine& line, const std::optional<std::string_view>& rest) {
  if (!rest || rest->empty()) return rest.has_value();
  return line.fail(ProblemCode::P0952, *rest, "the end of the line");
}

}  // namespace

std::optional<std::string_view> OfLine::parseLine(const StepLine& line, bool ofOne) {
  std::string_view rest = line.rest();
  const std::string_view name = takeName(rest);
  if (name.empty()) {
    line.fail(ProblemCode::P0952, line.whole(), "the name of a subnet");
    return std::nullopt;
  }
  subnet = name;
  subnetAt = line.at(name);
  std::string_view behind = rest;
  if (!ofOne || !equalsIgnoreCase(takeWord(behind), "at")) return rest;
  const std::string_view place = takeName(behind);
  if (place.empty()) {
    line.fail(ProblemCode::P0952, rest, "the name of a station");
    return std::nullopt;
  }
  station = place;
  stationAt = line.at(place);
  return behind;
}

void OfLine::resolve(const StepBinding& binding) {
  if (binding.stations == nullptr)
    return binding.problems.add(ProblemCode::P0704, subnetAt, subnet,
                                "left out with its step: the project has one station only");
  const bool known = std::ranges::any_of(
      *binding.stations, [&](const StationBinding& one) { return isOn(one, subnet); });
  if (!known)
    return binding.problems.add(
        ProblemCode::P0704, subnetAt, subnet,
        "the name of an MPI or Ethernet [[subnet]] with nodes; on PROFIBUS a "
        "slave has the fault: fault NAME line break");
  if (station.empty()) return;
  const StationBinding* const node = findStation(binding, station);
  if (node == nullptr || !isOn(*node, subnet))
    binding.problems.add(ProblemCode::P0704, stationAt, station, "a station on this subnet");
}

network::Subnet* OfLine::find(StepRun& run) const { return memberOf(run).network().subnet(subnet); }

std::optional<std::uint8_t> OfLine::address(StepRun& run) const {
  network::Network& all = memberOf(run).network();
  const auto number = all.find(station);
  return number ? all.addressOf(*number, *find(run)) : std::nullopt;
}

bool Break::parse(const StepLine& line) { return endsHere(line, parseLine(line, true)); }
bool Break::perform(StepRun& run) const {
  const auto place = address(run);
  place ? find(run)->interrupt(*place) : find(run)->interrupt();
  return true;
}

bool Short::parse(const StepLine& line) { return endsHere(line, parseLine(line, false)); }
bool Short::perform(StepRun& run) const {
  find(run)->interrupt();
  return true;
}

bool Delay::parse(const StepLine& line) {
  const auto rest = parseLine(line, false);
  if (!rest) return false;
  const auto length = parseDuration(*rest);
  if (!length) return line.fail(ProblemCode::P0953, rest->empty() ? line.rest() : *rest, *rest);
  time = *length;
  return true;
}
bool Delay::perform(StepRun& run) const {
  find(run)->delay(time);
  return true;
}

bool Mend::parse(const StepLine& line) { return endsHere(line, parseLine(line, true)); }
bool Mend::perform(StepRun& run) const {
  const auto place = address(run);
  place ? find(run)->mend(*place) : find(run)->mend();
  return true;
}

}  // namespace merker::simulator::steps
