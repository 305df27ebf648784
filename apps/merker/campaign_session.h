// What `merker campaign` does with a campaign and its file of results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/expansion.h"
#include "campaign/plan.h"
#include "campaign/report.h"
#include "campaign/results.h"
#include "campaign/wire.h"

namespace merker::app {

struct CampaignOptions {
  std::string file, output, shard, csv, junit;
  std::vector<std::string> merge;
  std::uint64_t job = 0;  // 0: all
  unsigned processes = 1;
  bool list = false, resume = false, json = false;
};

class CampaignSession {
 public:
  CampaignSession(const CampaignOptions& options, const campaign::Plan& plan, campaign::Shard shard)
      : options_(options), plan_(plan), shard_(shard) {}

  // A command line for each run. No file of results is touched by it.
  int list() const;
  // Runs or merges, and writes what is asked for. The exit code.
  int work();

 private:
  int open();
  bool areOurs(const std::set<std::string>& ids, const std::set<std::string>& known) const;
  std::set<std::string> known() const;
  int merge();
  int run();
  std::vector<std::uint64_t> open(const std::set<std::string>& done) const;
  bool keep(const std::vector<campaign::Arrived>& arrived);
  int conclude();
  int write();
  void tellFailed();
  int fail(const Problem& problem) const;
  std::string path() const;

  const CampaignOptions& options_;
  const campaign::Plan& plan_;
  campaign::Shard shard_;
  std::optional<campaign::Results> results_;
  std::optional<Problem> problem_;  // of writing
  std::size_t lost_ = 0;
  bool stopped_ = false;
};

}  // namespace merker::app
