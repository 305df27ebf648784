#include "itcp/page_values.h"

#include <fmt/format.h>

#include "itcp/value_text.h"

namespace merker::itcp {
namespace {

using s7comm::ItemCode;
using s7comm::Range;
using s7comm::Value;

// One place: its operand, or what it shows instead.
struct Place {
  std::optional<address::Reference> operand;
  std::string name, why;
};

PageValue shown(const Place& place, const Value& value) {
  if (value.code == ItemCode::Done) return {true, textOf(*place.operand, value.octets)};
  return {false, fmt::format("{} does not exist", place.name)};
}

std::vector<PageValue> shown(const std::vector<Place>& places, const std::vector<Value>& values) {
  std::vector<PageValue> result;
  auto value = values.begin();
  for (const Place& place : places)
    result.push_back(place.operand ? shown(place, *value++) : PageValue{false, place.why});
  return result;
}

}  // namespace

PageValues::Found PageValues::lookUp(const std::vector<std::string>& names,
                                     const monitor::Monitor* monitor) {
  Found found;
  for (const std::string& name : names) {
    Known known{std::nullopt, "the CPU does not answer"};
    if (monitor != nullptr) {
      auto operand = monitor->operand(name);
      if (!operand) known.why = operand.error().message;
      if (operand && rangeOf(*operand)) known.operand = std::move(*operand);
      if (operand && !known.operand) known.why = name + " cannot be shown";
    }
    found.emplace_back(name, std::move(known));
  }
  return found;
}

void PageValues::read(std::vector<std::string> names, Done done) {
  std::vector<std::string> unknown;
  for (const std::string& name : names)
    if (!known_.contains(name)) unknown.push_back(name);
  if (unknown.empty()) return answer(names, std::move(done));
  plc_.order([weak = weak_from_this(), names = std::move(names), unknown = std::move(unknown),
              done = std::move(done)](const monitor::Monitor* monitor) -> served::Exchange::Call {
    return [weak, names, done, found = lookUp(unknown, monitor)] {
      const auto self = weak.lock();
      if (!self) return;
      for (const auto& [name, known] : found) self->known_.insert_or_assign(name, known);
      self->answer(names, done);
    };
  });
}

void PageValues::answer(const std::vector<std::string>& names, Done done) {
  std::vector<Place> places;
  std::vector<Range> ranges;
  for (const std::string& name : names) {
    const auto found = known_.find(name);
    const Known known = found == known_.end() ? Known{} : found->second;
    if (known.operand) ranges.push_back(*rangeOf(*known.operand));
    places.push_back({known.operand, name, known.why});
  }
  if (ranges.empty()) return done(shown(places, {}));
  plc_.read(ranges, [places = std::move(places), done = std::move(done)](
                        const std::vector<Value>& values) { done(shown(places, values)); });
}

}  // namespace merker::itcp
