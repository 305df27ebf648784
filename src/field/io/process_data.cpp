#include "io/process_data.h"

#include "io/rack.h"

namespace merker::io {

// A master in STOP puts out zeros, which are no setpoints.
bool Rack::exchanging(std::uint32_t module) const {
  return present(module) && outputs_.supplied() && !outputs_.disabled();
}

std::int32_t Rack::received(const ProcessData& data) const {
  const std::uint32_t first = *of(data.module).outputStart + 2u * data.word;
  const std::uint16_t high = outputs_.word(first);
  if (data.words == 1) return static_cast<std::int16_t>(high);
  return static_cast<std::int32_t>(std::uint32_t{high} << 16 | outputs_.word(first + 2));
}

void Rack::answer(const ProcessData& data, std::int32_t value) {
  std::vector<std::uint8_t>& bytes = units_[data.module].answer;
  bytes.resize(of(data.module).type->inputBytes);
  const auto bits = static_cast<std::uint32_t>(value);
  for (unsigned i = 0, count = 2u * data.words; i < count; ++i)
    bytes[2u * data.word + i] = static_cast<std::uint8_t>(bits >> (8 * (count - 1 - i)));
  showAnswer(data.module);
}

void Rack::answer(std::uint32_t module, std::vector<std::uint8_t> bytes) {
  units_[module].answer = std::move(bytes);
  showAnswer(module);
}

void Rack::showAnswer(std::uint32_t index) {
  const std::vector<std::uint8_t>& bytes = units_[index].answer;
  for (std::uint32_t i = 0; i < bytes.size(); ++i)
    inputs_.set(*of(index).inputStart + i, present(index) ? bytes[i] : std::uint8_t{0});
}

}  // namespace merker::io
