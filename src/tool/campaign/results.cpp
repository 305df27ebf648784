#include "campaign/results.h"

#include <filesystem>
#include <system_error>

#include "campaign/schema.h"

namespace merker::campaign {
namespace {

using store::Database;
using store::Statement;

Problem unusable(const std::string& path, const std::exception& error) {
  return makeProblem(ProblemCode::P0786, Position{path}, error.what());
}

void bindValue(Statement& statement, const Value& value) {
  value.number ? statement.bindReal(*value.number) : statement.bind(std::string_view(value.text));
}

Outcome outcomeAt(const Statement& row, std::size_t measures) {
  Outcome outcome{row.integer(0) != 0,
                  row.text(1),
                  row.real(2),
                  static_cast<std::uint64_t>(row.integer(3)),
                  {}};
  for (std::size_t i = 0; i < measures; ++i) {
    const int column = static_cast<int>(4 + i);
    outcome.measures.push_back(row.isNull(column) ? std::nullopt : std::optional(row.real(column)));
  }
  return outcome;
}

}  // namespace

Result<Results> Results::open(const std::string& path, const Definition& definition) {
  try {
    auto database = std::make_unique<Database>(path, kMostColumns);
    if (auto problem = prepareSchema(*database, path, definition)) return *problem;
    Results results(path, std::move(database), definition.measures.size());
    results.insert_ =
        std::make_unique<Statement>(results.database_->prepare(insertText(definition)));
    results.find_ = std::make_unique<Statement>(results.database_->prepare(findText(definition)));
    return results;
  } catch (const std::exception& error) {
    return unusable(path, error);
  }
}

void Results::insert(Statement& statement, const Finished& one) const {
  statement.bind(std::string_view(one.id));
  for (const Value& value : one.choice.values) bindValue(statement, value);
  statement.bind(static_cast<std::int64_t>(one.choice.seed))
      .bind(std::int64_t{one.outcome.passed})
      .bind(std::string_view(one.outcome.message))
      .bindReal(one.outcome.seconds)
      .bind(static_cast<std::int64_t>(one.outcome.cycles));
  for (const auto& measure : one.outcome.measures)
    measure ? statement.bindReal(*measure) : statement.bindNull();
  statement.run();
}

std::optional<Problem> Results::add(const std::vector<Finished>& finished) {
  try {
    store::Transaction transaction(*database_);
    for (const Finished& one : finished) insert(*insert_, one);
    transaction.commit();
    return std::nullopt;
  } catch (const std::exception& error) {
    return unusable(path_, error);
  }
}

Result<std::set<std::string>> Results::ids() {
  try {
    std::set<std::string> ids;
    Statement rows = database_->prepare("SELECT id FROM run");
    while (rows.step()) ids.insert(rows.text(0));
    return ids;
  } catch (const std::exception& error) {
    return unusable(path_, error);
  }
}

Result<std::optional<Outcome>> Results::find(const std::string& id) {
  try {
    find_->bind(std::string_view(id));
    if (!find_->step()) return std::optional<Outcome>();
    std::optional<Outcome> outcome = outcomeAt(*find_, measures_);
    find_->step();  // to the end, ready for the next one
    return outcome;
  } catch (const std::exception& error) {
    return unusable(path_, error);
  }
}

Result<std::size_t> Results::addFrom(const std::string& path, const Definition& definition,
                                     const std::set<std::string>& known) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return makeProblem(ProblemCode::P0784, Position{path}, path, "there is no such file");
  try {
    Database other(path, kMostColumns);
    if (auto problem = checkSchema(other, path, definition)) return *problem;
    return copyRows(other, *database_, definition, known);
  } catch (const std::exception& failure) {
    return unusable(path, failure);
  }
}

void Results::close() {
  insert_.reset();
  find_.reset();
  database_.reset();  // who closes last puts the log into the file
}

}  // namespace merker::campaign
