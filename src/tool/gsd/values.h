// Numbers, bytes and texts behind the equals sign of a statement.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "gsd/device.h"
#include "gsd/statement.h"

namespace merker::gsd {

// "12", "-3", "0x1F", "1Fh".
std::optional<std::int64_t> number(std::string_view text);
// The first number, and the first text in quotation marks.
std::optional<std::int64_t> firstNumber(const Statement& statement);
std::string firstText(const Statement& statement);
// All words as they stand, for what is not in quotation marks.
std::string wholeText(const Statement& statement);
// "0-15", "0,1,4-7" from the value `from` on.
Ranges ranges(const Statement& statement, std::size_t from);
std::optional<std::pair<std::int64_t, std::int64_t>> range(std::string_view text);

// The numbers of a list as bytes.
Bytes bytes(const Statement& statement, const source::SourceFile& file,
            std::vector<Remark>& remarks);

}  // namespace merker::gsd
