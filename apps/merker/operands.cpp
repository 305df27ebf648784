#include "operands.h"

#include <algorithm>

#include "base/text.h"
#include "command.h"
#include "output.h"
#include "simulator/line.h"

namespace merker::app {
namespace {

// Each line of the list as a file of its own that problems can show. What is written well but
// missing in this program is no wrong usage.
int printed(const Problems& problems, const source::SourceFile& file) {
  printProblems(problems, [&](const std::string&) { return &file; });
  int result = kGood;
  for (const Problem& problem : problems.list())
    result = std::max<int>(result, problem.code == ProblemCode::P0962 ? kProblems : kUsage);
  return result;
}

}  // namespace

int readOperands(const std::string& option, const std::vector<std::string>& texts,
                 const simulator::Resolver& resolver, std::vector<mc7::Reference>& operands) {
  int result = kGood;
  for (const std::string& text : texts) {
    const source::SourceFile file(option, text);
    Problems problems;
    for (std::string_view part : simulator::splitList(file.text())) {
      const auto offset =
          part.empty() ? 0 : static_cast<std::size_t>(part.data() - file.text().data());
      simulator::Term term{std::string(part), file.position(offset, part.size()), {}, {}, {}};
      if (part.empty())
        problems.add(ProblemCode::P0952, term.position, "an operand");
      else if (auto problem = simulator::resolveOperand(term, resolver))
        problems.add(*problem);
      else if (term.reference.operand.kind != mc7::OperandKind::Memory)
        term.reference.operand.width = Width::Word;
      operands.push_back(term.reference);
    }
    result = std::max(result, printed(problems, file));
  }
  return result;
}

int readAssignments(const std::string& option, const std::vector<std::string>& texts,
                    const simulator::Resolver& resolver,
                    std::vector<simulator::Assignment>& assignments) {
  int result = kGood;
  for (const std::string& text : texts) {
    const source::SourceFile file(option, text);
    Problems problems;
    for (simulator::Assignment& assignment :
         simulator::parseAssignments(file, file.text(), problems)) {
      simulator::resolve(assignment, resolver, problems);
      assignments.push_back(std::move(assignment));
    }
    result = std::max(result, printed(problems, file));
  }
  return result;
}

}  // namespace merker::app
