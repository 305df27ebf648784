#include "campaign_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "campaign_pool.h"
#include "command.h"
#include "input.h"
#include "output.h"
#include "progress.h"
#include "real_time.h"

namespace merker::app {
namespace {

using campaign::Choice;
using campaign::Outcome;

// A word of a command line as a shell takes it.
std::string shellWord(const std::string& text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./-+=:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + '\'';
}

std::string replaced(std::string text, const std::string& by) {
  constexpr std::string_view kPlace = "{}";
  for (std::size_t at = 0; (at = text.find(kPlace, at)) != std::string::npos; at += by.size())
    text.replace(at, kPlace.size(), by);
  return text;
}

}  // namespace

int CampaignSession::list() const {
  const std::uint64_t runs = plan_.definition().runs();
  for (std::uint64_t number = shard_.number - 1; number < runs; number += shard_.count) {
    const std::string job = std::to_string(number + 1);
    std::cout << "merker campaign " << shellWord(options_.file) << " --job " << job;
    if (!options_.output.empty()) std::cout << " -o " << shellWord(replaced(options_.output, job));
    std::cout << '\n';
  }
  return kGood;
}

// Beside the campaign's file, with the shard in its name.
std::string CampaignSession::path() const {
  if (!options_.output.empty()) return options_.output;
  const std::filesystem::path file = options_.file;
  const std::string shard =
      shard_.count > 1 ? fmt::format("-{}of{}", shard_.number, shard_.count) : "";
  return (file.parent_path() / (file.stem().string() + shard + ".sqlite")).string();
}

int CampaignSession::fail(const Problem& problem) const {
  Problems problems;
  problems.add(problem);
  printProblems(problems, [](const std::string&) { return nullptr; });
  return problem.code == ProblemCode::P0785 ? kUsage : kUnreadable;
}

int CampaignSession::open() {
  const std::string file = path();
  std::error_code error;
  const bool mayExist = options_.resume || options_.job > 0 || !options_.merge.empty();
  if (!mayExist && std::filesystem::exists(file, error)) {
    std::cerr << "merker campaign: " << file
              << " exists; --resume goes on with it, -o FILE writes to another file\n";
    return kUsage;
  }
  auto results = campaign::Results::open(file, plan_.definition());
  if (!results) return fail(results.error());
  results_ = std::move(results.value());
  return kGood;
}

std::set<std::string> CampaignSession::known() const {
  std::set<std::string> ids;
  const std::uint64_t runs = plan_.definition().runs();
  for (std::uint64_t number = 0; number < runs; ++number)
    ids.insert(plan_.id(plan_.choice(number)));
  return ids;
}

// A file may have rows of a project that has changed since; it would mix them with new ones.
bool CampaignSession::areOurs(const std::set<std::string>& ids,
                              const std::set<std::string>& known) const {
  const auto others =
      std::ranges::count_if(ids, [&](const std::string& id) { return !known.contains(id); });
  if (others == 0) return true;
  fail(makeProblem(ProblemCode::P0785, Position{results_->path()}, results_->path(),
                   fmt::format("{} of its {} runs are of another campaign, project or version",
                               others, ids.size())));
  return false;
}

int CampaignSession::merge() {
  const std::set<std::string> ours = known();
  auto ids = results_->ids();
  if (!ids) return fail(ids.error());
  if (!areOurs(ids.value(), ours)) return kUsage;
  for (const std::string& file : options_.merge) {
    const auto added = results_->addFrom(file, plan_.definition(), ours);
    if (!added) return fail(added.error());
    if (!options_.json) std::cout << file << ": " << added.value() << " runs added\n";
  }
  return kGood;
}

// Those with the same beginning behind each other.
std::vector<std::uint64_t> CampaignSession::open(const std::set<std::string>& done) const {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> open;
  const std::uint64_t runs = plan_.definition().runs();
  for (std::uint64_t number = shard_.number - 1; number < runs; number += shard_.count)
    if ((options_.job == 0 || options_.job == number + 1) &&
        !done.contains(plan_.id(plan_.choice(number))))
      open.emplace_back(plan_.beginning(number), number);
  std::ranges::sort(open);
  std::vector<std::uint64_t> numbers;
  for (const auto& [beginning, number] : open) numbers.push_back(number);
  return numbers;
}

bool CampaignSession::keep(const std::vector<campaign::Arrived>& arrived) {
  std::vector<campaign::Finished> finished;
  for (const campaign::Arrived& one : arrived) {
    Choice choice = plan_.choice(one.number);
    std::string id = plan_.id(choice);
    finished.push_back({std::move(id), std::move(choice), one.outcome});
  }
  if (!finished.empty()) problem_ = results_->add(finished);
  return !problem_;
}

int CampaignSession::run() {
  auto done = results_->ids();
  if (!done) return fail(done.error());
  if (options_.job == 0 && !done->empty() && !areOurs(done.value(), known())) return kUsage;
  const std::vector<std::uint64_t> numbers = open(done.value());
  Progress progress("campaign:");
  std::uint64_t count = 0;
  const auto take = [&](const std::vector<campaign::Arrived>& arrived) {
    count += arrived.size();
    progress.show(count, numbers.size());
    return keep(arrived);
  };
  holdSignals();
  CampaignPool pool(plan_, options_.processes, take, endAsked);
  stopped_ = !pool.run(numbers) && !problem_;
  if (problem_) return fail(*problem_);
  lost_ = pool.lost().size();
  for (const LostRun& lost : pool.lost())
    std::cerr << fmt::format("merker campaign: run {} ({}) has no result: {}\n", lost.number + 1,
                             campaign::describe(plan_.definition(), plan_.choice(lost.number)),
                             lost.why);
  return kGood;
}

int CampaignSession::write() {
  const auto file = [&](const std::string& path, auto writer) {
    if (path.empty()) return true;
    std::ostringstream out;
    if (const auto problem = writer(plan_, shard_, *results_, out)) return fail(*problem) == kGood;
    return writeText(path, out.str());
  };
  const bool good =
      file(options_.csv, campaign::writeCsv) & file(options_.junit, campaign::writeJunit);
  return good ? kGood : kUnreadable;
}

int CampaignSession::conclude() {
  constexpr std::size_t kMostTold = 10, kMostInJson = 1000;
  nlohmann::ordered_json failures = nlohmann::ordered_json::array();
  std::uint64_t told = 0;
  const auto one = [&](const Choice& choice, const std::string&, const Outcome& outcome) {
    if (outcome.passed) return;
    const std::string what = campaign::describe(plan_.definition(), choice);
    if (options_.json && failures.size() < kMostInJson)
      failures.push_back(
          {{"run", choice.number + 1}, {"parameters", what}, {"message", outcome.message}});
    if (!options_.json && ++told <= kMostTold)
      std::cout << fmt::format("FAILED  run {} ({}): {}\n", choice.number + 1, what,
                               outcome.message);
  };
  const auto summary = campaign::eachOutcome(plan_, shard_, *results_, one);
  if (!summary) return fail(summary.error());
  const auto& [passed, failed, missing] = summary.value();
  if (options_.json)
    print({{"runs", passed + failed + missing},
           {"passed", passed},
           {"failed", failed},
           {"missing", missing},
           {"results", results_->path()},
           {"failures", failures}});
  else if (options_.job == 0)
    std::cout << (told > kMostTold ? fmt::format("... and {} more\n", told - kMostTold) : "")
              << fmt::format("{} passed, {} failed{}; results in {}\n", passed, failed,
                             missing > 0 ? fmt::format(", {} missing", missing) : "",
                             results_->path());
  if (stopped_)
    std::cerr << fmt::format("merker campaign: stopped after {} of {} runs; --resume goes on\n",
                             passed + failed, passed + failed + missing);
  const bool whole = options_.job > 0 ? lost_ == 0 : missing == 0;
  return failed == 0 && whole && !stopped_ ? kGood : kProblems;
}

int CampaignSession::work() {
  if (const int bad = open(); bad != kGood) return bad;
  if (const int bad = options_.merge.empty() ? run() : merge(); bad != kGood) return bad;
  const int result = conclude();
  const int written = write();
  results_->close();
  return written != kGood ? written : result;
}

}  // namespace merker::app
