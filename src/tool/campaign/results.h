// The results of a campaign: one SQLite file with a row for each run that is over. A process that
// is killed at any moment leaves whole rows; a run has one row, whoever writes it how often.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "campaign/run.h"
#include "store/database.h"

namespace merker::campaign {

struct Finished {
  std::string id;
  Choice choice;
  Outcome outcome;
};

class Results {
 public:
  // Opens the file, or makes a new one with the columns of the campaign.
  static Result<Results> open(const std::string& path, const Definition& definition);

  // All of them, or none, before it returns. A run that is there stays as it is.
  std::optional<Problem> add(const std::vector<Finished>& finished);
  // Those of another file with the same columns that are among `known`; how many are new.
  Result<std::size_t> addFrom(const std::string& path, const Definition& definition,
                              const std::set<std::string>& known);
  Result<std::set<std::string>> ids();
  Result<std::optional<Outcome>> find(const std::string& id);
  // The file alone holds everything from here on.
  void close();
  const std::string& path() const { return path_; }

 private:
  Results(std::string path, std::unique_ptr<store::Database> database, std::size_t measures)
      : path_(std::move(path)), database_(std::move(database)), measures_(measures) {}
  void insert(store::Statement& statement, const Finished& one) const;

  std::string path_;
  std::unique_ptr<store::Database> database_;
  std::size_t measures_;
  std::unique_ptr<store::Statement> insert_, find_;
};

}  // namespace merker::campaign
