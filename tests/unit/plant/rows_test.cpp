// Every figure of the kinds of plants: docs/formats/project.md describes them.
#include "../rows.h"

#include <fmt/format.h>

#include "plant/kind.h"

namespace merker::plant {
namespace {

TEST(Rows, Kinds) {
  std::string rows;
  for (const Kind* kind : kinds()) {
    rows += fmt::format("{} step {} ns\n", kind->name, kind->step.ns);
    for (const Parameter& p : kind->parameters)
      rows += fmt::format("  parameter {} form {} standard {} of {}..{}\n", p.key,
                          static_cast<int>(p.form), p.standard, p.low, p.high);
    for (const Signal& s : kind->signals)
      rows += fmt::format("  {} {}{} rest {} of {}..{} {}\n",
                          s.side == Signal::Side::Input ? "input" : "output", s.name,
                          s.binary ? " binary" : "", s.rest, s.low, s.high, s.unit);
  }
  test::expectRows("plant/kinds.txt", rows);
}

}  // namespace
}  // namespace merker::plant
