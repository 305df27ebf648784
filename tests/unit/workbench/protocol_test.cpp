// The table of the protocol against the handlers: which requests there are, what they need, and
// which fields they read. That answers and events are as the table has them: bench.h, in each test.
#include <algorithm>
#include <cmath>

#include "bench.h"

namespace merker::workbench::test {
namespace {

using Form = Shape::Kind;

std::vector<const Method*> allMethods() {
  std::vector<const Method*> all;
  for (const auto group : methodGroups())
    for (const Method& one : group) all.push_back(&one);
  return all;
}

TEST(Protocol, EachRequestIsARowOfTheTable) {
  for (const Method* method : allMethods()) {
    const MethodRow* row = findMethodRow(method->name);
    ASSERT_NE(row, nullptr) << method->name;
    EXPECT_EQ(row->state, method->needs.state) << method->name;
    EXPECT_EQ(row->feature, method->needs.feature ? monitor::name(*method->needs.feature) : "")
        << method->name;
    EXPECT_EQ(row->kind, method->kind) << method->name;
  }
}

TEST(Protocol, EachRowOfTheTableIsARequest) {
  for (const MethodRow& row : methodRows()) EXPECT_NE(findMethod(row.name), nullptr) << row.name;
  EXPECT_EQ(methodRows().size(), allMethods().size());
}

// A request, and the field of which a problem is expected.
struct Probe {
  Json request;
  std::string field;
  const char* code;
};

// Values that are not as the shape has it.
std::vector<Json> wrongValues(const Shape& shape) {
  const Json never = Json::array({Json::object()});
  if (shape.kind == Form::Word || shape.kind == Form::Either) return {never, "?"};
  if (shape.kind == Form::Whole)
    return {never, shape.low - 1, std::floor(shape.high * 1.01 + 1), shape.low + 0.5};
  if (shape.kind == Form::Number && shape.high < 1e300)
    return {never, shape.low * 1.01 - 1, shape.high * 1.01};
  if (shape.kind == Form::List) return {Json::object(), Json::array({Json::array()})};
  return {never};
}

// A value that the shape allows.
Json sampleOf(const Shape& shape) {
  if (shape.kind == Form::Either) return sampleOf(shape.parts[0]);
  if (shape.kind == Form::Word) return shape.word;
  if (shape.kind == Form::Whole || shape.kind == Form::Number) return shape.low;
  if (shape.kind == Form::Flag) return false;
  if (shape.kind == Form::List) return Json::array();
  return "x";
}

// Of one field of an object; its other fields are there and good.
void probeField(const Shape& object, const Shape& field, std::vector<Probe>& probes) {
  Json good = Json::object();
  for (const Shape& other : object.parts)
    if (!other.optional && other.name != field.name) good[other.name] = sampleOf(other);
  if (!field.optional) probes.push_back({good, field.name, "P1306"});
  for (const Json& wrong : wrongValues(field)) {
    const bool item = wrong.is_array() && wrong[0].is_array();
    good[field.name] = wrong;
    probes.push_back({good, field.name + (item ? "[0]" : ""), "P1305"});
  }
  if (field.kind != Form::List || field.parts[0].kind != Form::Object) return;
  std::vector<Probe> inside;
  for (const Shape& one : field.parts[0].parts) probeField(field.parts[0], one, inside);
  for (const Probe& one : inside) {
    good[field.name] = Json::array({one.request});
    probes.push_back({good, field.name + "[0]." + one.field, one.code});
  }
}

bool told(const Json& answer, const Probe& probe) {
  return answer.contains("problems") &&
         std::ranges::any_of(answer["problems"], [&](const Json& one) {
           return one["code"] == probe.code && one["arguments"][0] == probe.field;
         });
}

const char* const kRack = R"([cpu]
model = "314C-2 PtP"
[[plant]]
kind = "tank"
name = "Tank"
)";

// A change in a merker.toml has fields of its own: hardware_test.
bool ofAChange(const Probe& probe) { return probe.field.starts_with("changes[0]."); }

class ProtocolOf : public testing::TestWithParam<std::string> {};

// A field that a handler does not read, or reads with another type, range or words, shows here:
// it gets no problem.
TEST_P(ProtocolOf, EachFieldIsReadAsTheTableHasIt) {
  std::vector<Probe> probes;
  const Shape& fields = findMethodRow(GetParam())->fields;
  for (const Shape& field : fields.parts) probeField(fields, field, probes);
  Bench bench(kProgram, kRack);
  bench.call("record.start");
  for (Probe& probe : probes)
    if (!ofAChange(probe)) {
      const std::string sent = probe.request.dump();
      const Json answer = bench.ask(GetParam(), std::move(probe.request));
      EXPECT_TRUE(told(answer, probe))
          << sent << ": " << probe.code << " of " << probe.field << " expected, " << answer;
    }
}

TEST_P(ProtocolOf, HasNoOtherField) {
  const auto problem = unknownField(*findMethod(GetParam()), {{"unheardOf", 1}});
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->message.find("unheardOf"), std::string::npos) << problem->message;
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const MethodRow& row : methodRows()) list.emplace_back(row.name);
  return list;
}

std::string testName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Requests, ProtocolOf, testing::ValuesIn(names()), testName);

TEST(Protocol, AnUnknownFieldOfAnItemIsNamedWithItsPlace) {
  const auto problem =
      unknownField(*findMethod("variables.read"),
                   {{"items", {{{"operand", "MW 0"}}, {{"operand", "MW 2"}, {"from", 1}}}}});
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->message, "field 'items[1].from' not found; valid: operand, format");
}

// A newer client may send more than this server reads.
TEST(Protocol, UnknownFieldsAreIgnored) {
  Bench bench;
  EXPECT_TRUE(bench.ask("ping", {{"unheardOf", 1}}).contains("result"));
}

TEST(Protocol, AnAnswerThatIsNotAsTheTableHasItIsFound) {
  const Shape& result = findMethodRow("files.read")->result;
  EXPECT_EQ(mismatch(result, {{"text", ""}, {"revision", 1}}, "r"), "");
  EXPECT_EQ(mismatch(result, {{"text", ""}}, "r"), "r.revision lacks");
  EXPECT_EQ(mismatch(result, {{"text", ""}, {"revision", 1}, {"size", 2}}, "r"),
            "r.size is not in the table");
  EXPECT_EQ(mismatch(result, {{"text", 5}, {"revision", 1}}, "r"), "r.text is not so: 5");
}

}  // namespace
}  // namespace merker::workbench::test
