#include "scenario/step_line.h"

#include <algorithm>
#include <charconv>

namespace merker::simulator {

Position StepLine::at(std::string_view part) const {
  if (part.empty()) part = whole_;
  const auto offset = static_cast<std::size_t>(part.data() - file_.text().data());
  return file_.position(offset, std::max<std::size_t>(part.size(), 1));
}

bool StepLine::ends() const {
  return rest_.empty() || fail(ProblemCode::P0959, rest_, rest_, whole_);
}

bool StepLine::number(std::string_view text, std::uint64_t& value) const {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value <= 1'000'000'000)
    return true;
  value = 0;
  return fail(ProblemCode::P0952, text, "a whole number from 0 to 1000000000");
}

bool StepLine::term(Term& term, std::string_view text, std::string_view where,
                    std::string_view what) const {
  if (text.empty()) return fail(ProblemCode::P0952, where, what);
  term.text = text;
  term.position = at(text);
  return true;
}

}  // namespace merker::simulator
