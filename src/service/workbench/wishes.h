// items: [{operand, value, format}] of a request.
#pragma once

#include <string>
#include <vector>

#include "monitor/monitor.h"
#include "workbench/fields.h"
#include "workbench/watch_list.h"

namespace merker::workbench {

monitor::DisplayFormat formatOf(const Fields& item);
// One of a list that is looked at: what is wrong with it stays with it, the others are looked at.
WatchItem watchItem(const Fields& item);

class Wishes {
 public:
  explicit Wishes(const Fields& fields);
  // They look at the texts in here.
  std::vector<monitor::Wish> list() const;

 private:
  struct Texts {
    std::string operand, value;
    monitor::DisplayFormat format;
  };
  std::vector<Texts> texts_;
};

// Takes out those that have a problem: [{item, problem}], `item` as they stood in the list.
template <class ProblemOf>
Json leaveOut(std::vector<monitor::Wish>& wishes, ProblemOf problemOf) {
  Json refused = Json::array();
  std::vector<monitor::Wish> good;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    if (const std::optional<Problem> problem = problemOf(wishes[i]))
      refused.push_back({{"item", i}, {"problem", toJson(*problem)}});
    else
      good.push_back(wishes[i]);
  }
  wishes = std::move(good);
  return refused;
}

}  // namespace merker::workbench
