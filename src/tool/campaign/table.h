// Results read again, for pictures.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "campaign/definition.h"

namespace merker::campaign {

struct ResultTable {
  struct Row {
    std::vector<Value> parameters;
    std::vector<std::optional<double>> measures;
  };
  std::string name;
  std::vector<std::string> parameters, measures;  // `seed` is the last parameter
  std::vector<Row> rows;
};

// Whether a file is one of SQLite, by its first bytes.
bool isDatabase(const std::string& path);
Result<ResultTable> readTable(const std::string& path);

}  // namespace merker::campaign
