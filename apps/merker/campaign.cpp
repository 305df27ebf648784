// merker campaign FILE.toml
#include <CLI/CLI.hpp>
#include <iostream>
#include <thread>

#include "base/text.h"
#include "build.h"
#include "campaign_session.h"
#include "command.h"
#include "engine_option.h"
#include "output.h"

namespace merker::app {
namespace {

int badUsage(const std::string& text) {
  std::cerr << "merker campaign: " << text << '\n';
  return kUsage;
}

// What is wrong with the project for each CPU model.
int reportProject(const campaign::Plan& plan) {
  int result = kGood;
  for (const auto& variant : plan.variants()) {
    printProblems(variant->build.problems, variant->build.files());
    result = std::max(result, exitCode(variant->build));
    if (result != kGood) break;  // the others have the same ones
  }
  return result;
}

bool wantsCompiled(const campaign::Definition& definition) {
  for (const campaign::Parameter& one : definition.parameters)
    for (const campaign::Parameter::Listed& listed : one.values)
      if (equalsIgnoreCase(one.name, "cpu.engine") && listed.value.text == "jit") return true;
  return false;
}

// Nothing beside the file is read before it is right.
int prepare(const CampaignOptions& options, std::unique_ptr<campaign::Plan>& plan) {
  Problems problems;
  auto file = source::readSource(options.file);
  if (!file) {
    problems.add(file.error());
    printProblems(problems, [](const std::string&) { return nullptr; });
    return kUnreadable;
  }
  const auto files = [&](const std::string& name) -> const source::SourceFile* {
    return name == file->name() ? &file.value() : plan ? plan->file(name) : nullptr;
  };
  campaign::Definition definition = campaign::readDefinition(file.value(), problems);
  if (!problems.hasErrors()) {
    plan = std::make_unique<campaign::Plan>(std::move(definition), problems);
    if (const int bad = reportProject(*plan); bad != kGood) return bad;
  }
  if (plan) plan->bind(MERKER_VERSION, problems);  // all that is wrong at once
  printProblems(problems, files);
  return problems.hasErrors() ? kProblems : kGood;
}

int campaignOf(const CampaignOptions& options) {
  std::optional<campaign::Shard> shard = campaign::Shard{};
  if (!options.shard.empty()) shard = campaign::parseShard(options.shard);
  if (!shard)
    return badUsage("--shard: '" + options.shard +
                    "' is not a part of the runs; write 3/16, from 1/16 to 16/16");
  std::unique_ptr<campaign::Plan> plan;
  if (const int bad = prepare(options, plan); bad != kGood) return bad;
  if (const auto why = wantsCompiled(plan->definition()) ? whyMissing("jit") : std::nullopt)
    return badUsage(*why);
  const std::uint64_t runs = plan->definition().runs();
  if (options.job > runs)
    return badUsage("--job: the campaign has " + std::to_string(runs) + " runs");
  CampaignSession session(options, *plan, *shard);
  return options.list ? session.list() : session.work();
}

}  // namespace

void addCampaign(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "campaign", "many runs with varied parameters and seeds; results in a SQLite file");
  auto options = std::make_shared<CampaignOptions>();
  options->processes = std::max(1u, std::thread::hardware_concurrency());
  command->add_option("FILE", options->file, "what is varied and measured: FILE.toml")->required();
  command
      ->add_option("-j,--jobs", options->processes,
                   "runs at the same time; otherwise one for each processor")
      ->check(CLI::Range(1u, 256u));
  command->add_option("-o,--output", options->output,
                      "file of results; otherwise FILE.sqlite. With --list {} is the run's number");
  auto* list = command->add_flag(
      "--list", options->list, "only print a command line for each run, for GNU parallel or Slurm");
  auto* shard =
      command->add_option("--shard", options->shard,
                          "one of several parts of the runs, each for another machine: 3/16");
  auto* job = command->add_option("--job", options->job, "only this run, counted from 1")
                  ->check(CLI::Range(std::uint64_t{1}, campaign::kMostRuns));
  command->add_flag("--resume", options->resume,
                    "go on with a file of results: do what is missing");
  command
      ->add_option("--merge", options->merge,
                   "run nothing: take the runs of these files of results, those of shards")
      ->excludes(list)
      ->excludes(shard)
      ->excludes(job);
  job->excludes(list)->excludes(shard);
  command->add_option("--csv", options->csv, "write the results as CSV");
  command->add_option("--junit", options->junit, "write the results as JUnit XML");
  command->add_flag("--json", options->json, "the summary as one JSON object");
  command->footer(
      "docs/formats/campaign.md describes FILE.toml. Exit code 1: a run failed or is missing.\n"
      "Examples:\n"
      "  merker campaign sweep.toml --csv sweep.csv\n"
      "  merker campaign sweep.toml --list | parallel\n"
      "  merker campaign sweep.toml --shard 3/16\n"
      "  merker campaign sweep.toml --merge sweep-*of16.sqlite\n"
      "  merker plot sweep.sqlite -o sweep.svg --x plant.Vessel.stroke --y emptied");
  command->callback([options, &result] { result = campaignOf(*options); });
}

}  // namespace merker::app
