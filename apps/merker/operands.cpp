#include "operands.h"

#include "base/text.h"
#include "output.h"
#include "simulator/line.h"

namespace merker::app {
namespace {

// Each line of the list as a file of its own that problems can show.
bool printed(const Problems& problems, const source::SourceFile& file) {
  printProblems(problems, [&](const std::string&) { return &file; });
  return !problems.hasErrors();
}

}  // namespace

bool readOperands(const std::string& option, const std::vector<std::string>& texts,
                  const simulator::Resolver& resolver, std::vector<mc7::Reference>& operands) {
  bool good = true;
  for (const std::string& text : texts) {
    const source::SourceFile file(option, text);
    Problems problems;
    for (std::string_view part : simulator::splitList(file.text())) {
      const auto offset =
          part.empty() ? 0 : static_cast<std::size_t>(part.data() - file.text().data());
      simulator::Term term{std::string(part), file.position(offset, part.size()), {}, {}};
      if (part.empty())
        problems.add(ProblemCode::P0952, term.position, "an operand");
      else if (auto problem = simulator::resolveOperand(term, resolver))
        problems.add(*problem);
      else if (term.reference.operand.kind != mc7::OperandKind::Memory)
        term.reference.operand.width = Width::Word;
      operands.push_back(term.reference);
    }
    good = printed(problems, file) && good;
  }
  return good;
}

bool readAssignments(const std::string& option, const std::vector<std::string>& texts,
                     const simulator::Resolver& resolver,
                     std::vector<simulator::Assignment>& assignments) {
  bool good = true;
  for (const std::string& text : texts) {
    const source::SourceFile file(option, text);
    Problems problems;
    for (simulator::Assignment& assignment :
         simulator::parseAssignments(file, file.text(), problems)) {
      if (auto problem = simulator::resolve(assignment, resolver)) problems.add(*problem);
      assignments.push_back(std::move(assignment));
    }
    good = printed(problems, file) && good;
  }
  return good;
}

}  // namespace merker::app
