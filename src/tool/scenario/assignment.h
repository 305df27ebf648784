// What `set` and `force` write: an operand and its value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plc/controller.h"
#include "scenario/step_line.h"
#include "scenario/term.h"
#include "source/source_file.h"

namespace merker::simulator {

struct Assignment {
  Term operand, value;
};

// "E 0.0 = 1, MW 10 = 5": what stands behind `set`, and what `merker run --set` takes. Texts are
// views into `file`.
std::vector<Assignment> parseAssignments(const source::SourceFile& file, std::string_view text,
                                         Problems& problems);
std::vector<Assignment> parseAssignments(const StepLine& line);
// Binds both sides to the program and checks that the value fits.
void resolve(Assignment& assignment, const Resolver& resolver, Problems& problems);
// Writes or forces the value; the reason if that is not possible, else empty.
std::string apply(const Assignment& assignment, bool force, controller::Controller& plc);

}  // namespace merker::simulator
