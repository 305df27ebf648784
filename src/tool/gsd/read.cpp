#include "gsd/read.h"

#include <algorithm>

#include "base/text.h"
#include "gsd/reader.h"
#include "gsd/values.h"

namespace merker::gsd {
namespace {

bool isHeading(const Statement& s) { return s.keyword.starts_with('#'); }

bool isDp(const Statement& s) {
  return equalsIgnoreCase(s.keyword + (s.keyword == "#" ? wholeText(s) : ""), "#Profibus_DP");
}

bool isTelling(const Statement& s) {
  return s.assigns &&
         (equalsIgnoreCase(s.keyword, "Ident_Number") || equalsIgnoreCase(s.keyword, "Module"));
}

}  // namespace

source::SourceFile decode(std::string name, std::string bytes) {
  const Encoding found = detectEncoding(bytes);
  const Encoding encoding = found == Encoding::Binary ? Encoding::Cp1252 : found;
  if (encoding == Encoding::Cp1252) std::ranges::replace(bytes, '\xA0', ' ');  // no-break blank
  return {std::move(name), toUtf8(bytes, encoding)};
}

Reading read(const source::SourceFile& file) {
  Reading reading;
  const auto statements = readStatements(file, reading.remarks);
  const bool headed = std::ranges::any_of(statements, isDp);
  reading.isGsd = headed || std::ranges::any_of(statements, isTelling);
  if (!reading.isGsd) return reading;
  if (!headed) reading.remarks.push_back({1, 1, "the line #Profibus_DP is missing"});
  Reader reader(file, reading);
  bool dp = !headed;
  for (const Statement& statement : statements) {
    if (isHeading(statement))
      dp = isDp(statement);
    else if (dp)
      reader.read(statement);
  }
  reader.finish();
  std::ranges::stable_sort(reading.remarks, {}, &Remark::line);
  return reading;
}

}  // namespace merker::gsd
