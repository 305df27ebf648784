// The line of a step while it is parsed. Every text is a view into the file, so that a problem can
// point at it.
#pragma once

#include <cstdint>
#include <string_view>

#include "scenario/line.h"
#include "scenario/term.h"
#include "source/source_file.h"

namespace merker::simulator {

class StepLine {
 public:
  // `whole`: the line without its comment, `rest`: what follows the words of the step.
  StepLine(const source::SourceFile& file, std::string_view whole, std::string_view rest,
           Problems& problems)
      : file_(file), whole_(whole), rest_(rest), problems_(problems) {}

  std::string_view whole() const { return whole_; }
  std::string_view rest() const { return rest_; }
  Problems& problems() const { return problems_; }
  // An empty part may have lost its place; the whole line stands for it.
  Position at(std::string_view part) const;
  PositionOf positions() const {
    return [this](std::string_view part) { return at(part); };
  }

  // A problem at this part. Always false, as all parsing that has failed.
  template <typename... Arguments>
  bool fail(ProblemCode code, std::string_view part, const Arguments&... arguments) const {
    problems_.add(code, at(part), arguments...);
    return false;
  }

  // Nothing may follow the words of the step.
  bool ends() const;
  // From 0 to 1000000000.
  bool number(std::string_view text, std::uint64_t& value) const;
  // An operand or a value; `where` is the part that it is missing in, `what` what it is called.
  bool term(Term& term, std::string_view text, std::string_view where, std::string_view what) const;

 private:
  const source::SourceFile& file_;
  std::string_view whole_, rest_;
  Problems& problems_;
};

}  // namespace merker::simulator
