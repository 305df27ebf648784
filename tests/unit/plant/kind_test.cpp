#include "plant/kind.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace merker::plant {
namespace {

// Every row makes a process of its standards, and all standards lie in their ranges.
TEST(Kind, rowsAreWhole) {
  std::set<std::string_view> names;
  for (const Kind* kind : kinds()) {
    EXPECT_TRUE(names.insert(kind->name).second) << kind->name;
    std::vector<double> parameters, values;
    for (const Parameter& parameter : kind->parameters) {
      EXPECT_LE(parameter.low, parameter.standard) << kind->name << ' ' << parameter.key;
      EXPECT_GE(parameter.high, parameter.standard) << kind->name << ' ' << parameter.key;
      parameters.push_back(parameter.standard);
    }
    for (const Signal& signal : kind->signals) values.push_back(signal.rest);
    const auto process = kind->make(parameters);
    process->begin(values);
    process->advance(Instant{}, Instant{1'000'000}, values);
    EXPECT_GT(process->next(), Instant{0}) << kind->name;
  }
}

TEST(Kind, namesIgnoreCase) {
  EXPECT_EQ(findKind("First Order"), findKind("first order"));
  EXPECT_EQ(findKind("nothing"), nullptr);
  EXPECT_EQ(findKind("first order")->signal("pv"), findKind("first order")->signal("PV"));
  EXPECT_FALSE(findKind("first order")->signal("SP"));
  EXPECT_NE(kindNames().find("bouncing switch"), std::string::npos);
}

}  // namespace
}  // namespace merker::plant
