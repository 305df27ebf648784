#include "scenario/long_number.h"

#include <charconv>
#include <cstdint>
#include <string>

namespace merker::simulator {

std::optional<Problem> beyondDoubleWord(std::string_view text, const Position& at) {
  const bool sign = text.starts_with('-') || text.starts_with('+');
  const std::string_view digits = text.substr(sign ? 1 : 0);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos)
    return std::nullopt;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const std::int64_t most = text.starts_with('-') ? -std::int64_t{INT32_MIN} : UINT32_MAX;
  if (error == std::errc() && value <= most) return std::nullopt;
  return makeProblem(ProblemCode::P0955, at, std::string(text), "a double word", 32);
}

}  // namespace merker::simulator
