#include "operands.h"

#include <algorithm>

#include "base/text.h"
#include "command.h"
#include "output.h"
#include "scenario/line.h"
#include "scenario/watched.h"

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

// Calls `read` with each part of the lists, its position and where its problems go.
template <typename Read>
int readLists(const std::string& option, const std::vector<std::string>& texts, Read read) {
  int result = kGood;
  for (const std::string& text : texts) {
    const source::SourceFile file(option, text);
    Problems problems;
    for (const std::string_view part : simulator::splitList(file.text())) {
      const auto offset =
          part.empty() ? 0 : static_cast<std::size_t>(part.data() - file.text().data());
      read(part, file.position(offset, part.size()), problems);
    }
    result = std::max(result, printed(problems, file));
  }
  return result;
}

// "plant Press/Oven.PV" without the station, which is named by what is in front of the slash.
std::string withoutStation(std::string_view part, const compilation::NetworkOperands& operands,
                           std::optional<std::size_t>& station) {
  std::string_view name = part;
  const std::string_view word = simulator::takeWord(name);
  const bool outside = equalsIgnoreCase(word, "plant") || equalsIgnoreCase(word, "terminal");
  std::string_view rest = outside ? name : part;
  station = operands.takeStation(rest);
  return outside ? std::string(word) + ' ' + std::string(rest) : std::string(rest);
}

void nameStation(const std::string& station, simulator::Watched& watched) {
  const auto add = [&](auto& list) {
    for (auto& one : list) one.text = station + '/' + one.text;
  };
  add(watched.operands);
  add(watched.plants);
  add(watched.terminals);
  add(watched.axis);
}

}  // namespace

int readWatched(const std::string& option, const std::vector<std::string>& texts,
                const simulator::Resolver& resolver, const plant::Configuration& plants,
                const io::Configuration* hardware, simulator::Watched& watched) {
  return readLists(option, texts, [&](auto part, const Position& position, Problems& problems) {
    simulator::readWatchable(part, position, {resolver, plants, hardware}, watched, problems);
  });
}

int readWatched(const std::string& option, const std::vector<std::string>& texts,
                const compilation::NetworkBuild& build,
                const compilation::NetworkOperands& operands,
                std::vector<StationWatched>& watched) {
  return readLists(option, texts, [&](auto part, const Position& position, Problems& problems) {
    std::optional<std::size_t> station;
    const std::string own = withoutStation(part, operands, station);
    if (!station) return problems.add(operands.unknown(part, position));
    const compilation::NamedBuild& one = build.stations[*station];
    const auto& hardware = one.build->project.hardware;
    const auto resolver = operands.resolver(*station);
    watched.push_back({*station, {}});
    simulator::readWatchable(own, position,
                             {resolver, one.build->project.plants, hardware ? &*hardware : nullptr},
                             watched.back().what, problems);
    nameStation(one.name, watched.back().what);
  });
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
