#include "workbench/wishes.h"

#include "workbench/shared.h"

namespace merker::workbench {

monitor::DisplayFormat formatOf(const Fields& item) {
  const auto format = monitor::parseFormat(item.text("format", "AUTO"));
  if (format) return *format;
  item.add(format.error());
  return monitor::DisplayFormat::Automatic;
}

WatchItem watchItem(const Fields& item) {
  WatchItem result{item.text("operand"), {}, {}};
  const auto format = monitor::parseFormat(item.text("format", "AUTO"));
  if (format)
    result.format = *format;
  else
    result.problem = format.error();
  if (result.operand.size() <= Fields::kLongestName) return result;
  result.operand.clear();
  result.problem = makeProblem(ProblemCode::P1305, nowhere(), "operand",
                               fmt::format("a text of at most {} bytes", Fields::kLongestName));
  return result;
}

Wishes::Wishes(const Fields& fields) {
  for (const Fields& item : fields.objects("items", kItems))
    texts_.push_back(
        {item.name("operand"), item.name("value", Fields::kLongestValue), formatOf(item)});
}

std::vector<monitor::Wish> Wishes::list() const {
  std::vector<monitor::Wish> list;
  for (const Texts& one : texts_) list.push_back({one.operand, one.value, one.format});
  return list;
}

}  // namespace merker::workbench
