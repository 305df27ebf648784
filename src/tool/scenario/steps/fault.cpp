#include "scenario/steps/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "plant/field.h"
#include "scenario/terminal_value.h"

namespace merker::simulator::steps {
namespace {

// Takes `word` off the end.
bool takeLast(std::string_view& text, std::string_view word) {
  const auto blank = text.find_last_of(" \t");
  const std::string_view last = blank == std::string_view::npos ? text : text.substr(blank + 1);
  if (!equalsIgnoreCase(last, word)) return false;
  text = trim(text.substr(0, text.size() - last.size()));
  return true;
}

std::optional<std::uint32_t> channelNumber(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

// Takes "channel 3" off the end; false if the number is wrong.
bool takeChannel(std::string_view& text, std::optional<std::uint32_t>& channel) {
  const auto place = upper(text).rfind("CHANNEL");
  if (place == std::string::npos) return true;
  channel = channelNumber(trim(text.substr(place + std::string_view("channel").size())));
  text = trim(text.substr(0, place));
  return channel.has_value();
}

std::uint32_t allChannels(const ModuleType& type) {
  return std::max({std::uint32_t{type.digitalInputs}, std::uint32_t{type.digitalOutputs},
                   std::uint32_t{type.analogInputs}, std::uint32_t{type.analogOutputs}});
}

}  // namespace

bool Fault::parse(const StepLine& line) {
  const std::string_view text = line.rest();
  std::string_view rest = text;
  const std::string_view name = takeName(rest);
  module = name;
  position = line.at(name.empty() ? text : name);
  there = !takeLast(rest, "off");
  if (!takeChannel(rest, channel)) return line.fail(ProblemCode::P0952, text, "channel NUMBER");
  words = rest;
  wordsPosition = line.at(rest.empty() ? text : rest);
  return true;
}

void Fault::resolve(const StepBinding& binding) {
  if (binding.resolver.ofControl) return;
  const io::FaultName* known = io::findFault(words);
  if (known == nullptr)
    return binding.problems.add(ProblemCode::P0980, wordsPosition, words, io::faultNames());
  kind = known->kind;
  const io::Module* const found = findModule(module, position, binding.hardware, binding.problems);
  if (found == nullptr) return;
  const io::FaultName& fault = io::nameOf(kind);
  if (!io::possible(*found->type, kind))
    binding.problems.add(ProblemCode::P0982, position, found->title(), fault.words);
  else if (channel && (!fault.channel || *channel >= allChannels(*found->type)))
    binding.problems.add(ProblemCode::P0984, position, found->title(),
                         fault.channel
                             ? fmt::format("channel {}", *channel)
                             : fmt::format("fault '{}' of a single channel", fault.words));
}

bool Fault::perform(StepRun& run) const {
  auto* const field = controller::capability<plant::Field>(run.plc());
  if (field == nullptr) {
    const std::string reason = run.plc().fault(module, words, there);
    return reason.empty() || run.fail(reason);
  }
  io::Rack& rack = *field->rack();
  if (const auto place = rack.module(module)) rack.fault(*place, kind, channel, there);
  return true;
}

}  // namespace merker::simulator::steps
