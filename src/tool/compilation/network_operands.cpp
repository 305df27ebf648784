#include <fmt/format.h>

#include "base/text.h"
#include "compilation/network.h"

namespace merker::compilation {
namespace {

// "Press" of "Press/E 0.0"; a symbol may have a slash in it.
std::string_view nameInFront(std::string_view text) {
  const auto slash = text.find('/');
  const bool none = slash == std::string_view::npos || text.find('"') < slash;
  return none ? std::string_view{} : trim(text.substr(0, slash));
}

}  // namespace

NetworkOperands::NetworkOperands(const NetworkBuild& build) : build_(build) {
  std::map<const Build*, std::shared_ptr<const simulator::Resolver>> made;
  for (const NamedBuild& station : build.stations) {
    numbers_.emplace(upper(station.name), numbers_.size());
    auto& one = made[station.build.get()];
    if (!one) one = std::make_shared<const simulator::Resolver>(station.build->resolver());
    resolvers_.push_back(one);
  }
}

std::optional<std::size_t> NetworkOperands::find(std::string_view name) const {
  const auto found = numbers_.find(upper(name));
  return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> NetworkOperands::takeStation(std::string_view& text) const {
  const auto found = find(nameInFront(text));
  if (found) text = trim(text.substr(text.find('/') + 1));
  return found;
}

Problem NetworkOperands::unknown(std::string_view text, const Position& at) const {
  const std::string names = stationNames(*build_.project.network);
  const std::string_view name = nameInFront(text);
  if (!name.empty())
    return makeProblem(ProblemCode::P0704, at, name, "the name of a [[station]]: " + names);
  return makeProblem(ProblemCode::P0704, at, text,
                     fmt::format("written with its station: {}/{}; stations are {}",
                                 build_.stations.front().name, text, names));
}

Result<address::Reference> NetworkOperands::resolve(std::string_view text, const Position& at,
                                                    std::optional<std::size_t> station) const {
  std::string_view rest = text;
  if (const auto named = takeStation(rest))
    station = named;
  else if (!station || !nameInFront(text).empty())
    return unknown(text, at);
  auto reference = (*resolvers_[*station])(rest, at);
  if (!reference) return reference;
  reference->station = static_cast<std::uint16_t>(*station + 1);
  reference->text = text;
  return reference;
}

// Constants of a SINUMERIK are no constants of STEP 7, so they mean the same for all.
simulator::Resolver NetworkOperands::resolver(std::optional<std::size_t> station) const {
  const auto constants = [this](std::string_view text) -> std::optional<Constant> {
    for (const auto& one : resolvers_)
      if (one->constants) return one->constants(text);
    return std::nullopt;
  };
  return {[this, station](std::string_view text, const Position& at) {
            return resolve(text, at, station);
          },
          constants, station && resolvers_[*station]->ofControl};
}

}  // namespace merker::compilation
