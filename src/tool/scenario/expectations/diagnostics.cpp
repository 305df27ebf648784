#include "scenario/expectations/diagnostics.h"

#include <fmt/format.h>

#include "base/text.h"

namespace merker::simulator::expectations {

static std::string entryText(const controller::DiagnosticEntry& entry) {
  return fmt::format("16#{:04X} {}", entry.event, entry.text);
}

bool Diagnostics::parse(const StepLine& line, const Claim& claim) {
  std::string_view text = claim.subject;
  const std::string_view contains = takeWord(text);
  if (!equalsIgnoreCase(contains, "contains"))
    return line.fail(ProblemCode::P0952, claim.subject.empty() ? claim.whole : claim.subject,
                     "contains \"text\"");
  if (text.size() < 2 || text.front() != '"' || text.back() != '"')
    return line.fail(ProblemCode::P0952, text.empty() ? contains : text,
                     "a text in quotation marks");
  words = text.substr(1, text.size() - 2);
  return true;
}

bool Diagnostics::holds(controller::Controller& plc) const {
  for (const auto& entry : plc.diagnostics())
    if (upper(entryText(entry)).find(upper(words)) != std::string::npos) return true;
  return false;
}

std::string Diagnostics::actual(controller::Controller& plc) const {
  if (plc.diagnostics().empty()) return "the diagnostic buffer is empty";
  return "the newest entry is " + entryText(plc.diagnostics().back());
}

}  // namespace merker::simulator::expectations
