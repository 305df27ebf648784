// The tables in a file of results (docs/formats/campaign.md): `campaign` says what it is, `run` has
// the rows.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "campaign/definition.h"
#include "store/database.h"

namespace merker::campaign {

// Parameters, measures, and id, seed, passed, message, seconds, cycles.
constexpr int kMostColumns = static_cast<int>(kMostParameters + kMostMeasures) + 6;
constexpr std::int64_t kApplicationId = 0x4D4B4352;  // "MKCR"

// A name as SQL has it.
std::string sqlName(std::string_view name);

// Makes the tables, unless they are there; the problem if the file is something else, or has other
// columns.
std::optional<Problem> prepareSchema(store::Database& database, const std::string& path,
                                     const Definition& definition);
std::optional<Problem> checkSchema(store::Database& database, const std::string& path,
                                   const Definition& definition);

// What the table `campaign` says; empty without it.
std::string property(store::Database& database, std::string_view key);

// Columns in the order id, parameters, seed, passed, message, seconds, cycles, measures.
std::string insertText(const Definition& definition);
// passed, message, seconds, cycles, measures of an id.
std::string findText(const Definition& definition);
// Rows whose id is among `known`, in one transaction; how many were not there.
std::size_t copyRows(store::Database& from, store::Database& to, const Definition& definition,
                     const std::set<std::string>& known);

}  // namespace merker::campaign
