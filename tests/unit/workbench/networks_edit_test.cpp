// Networks are changed, copied and moved as lines of the text.
#include "networks_bench.h"

namespace merker::workbench::test {
namespace {

Json edited(Bench& bench, const Json& edit) {
  return bench.call("networks.edit", asked({{"network", 1}, {"edit", edit}}));
}

// S7-EDIT-13
TEST(Networks, AreEditedAsLinesOfTheText) {
  Bench bench;
  const Json answer =
      edited(bench, {{"action", "setOperand"}, {"node", 1}, {"pin", 0}, {"operands", {"E 7.7"}}});
  EXPECT_EQ(answer["from"], 8);
  EXPECT_EQ(answer["to"], 9);
  EXPECT_EQ(answer["lines"], Json({"      U     E 7.7;"}));
  EXPECT_EQ(answer["network"], 1);
  EXPECT_EQ(answer["node"], 1);
}

TEST(Networks, WithAnElementMoreSelectIt) {
  Bench bench;
  const Json answer = edited(
      bench, {{"action", "insert"}, {"node", 0}, {"place", "behind"}, {"element", "CONTACT_NOT"}});
  EXPECT_EQ(answer["lines"], Json({"      UN    ??.?;"}));
  EXPECT_EQ(answer["node"], 1);
}

TEST(Networks, RefuseWhatCannotBeThere) {
  Bench bench;
  const Json wrong = {
      {"action", "insert"}, {"node", 3}, {"place", "parallel"}, {"element", "CONTACT"}};
  const Json problem =
      bench.ask("networks.edit", asked({{"network", 1}, {"edit", wrong}}))["problems"][0];
  EXPECT_EQ(problem["code"], "P1308");
  EXPECT_EQ(problem["arguments"][1], "hier darf kein Abzweig beginnen");
  EXPECT_EQ(bench.problem("networks.edit", asked({{"network", 9}, {"edit", wrong}})), "P1308");
}

// The view decides: what only FUP shows is refused in KOP.
TEST(Networks, StayLadderInKop) {
  Bench bench;
  const Json edit = {{"action", "insert"}, {"node", 0}, {"place", "parallel"}, {"element", "XOR"}};
  const auto inView = [&](const Json& more) {
    Json fields = asked({{"network", 1}, {"edit", edit}});
    fields.update(more);
    return bench.ask("networks.edit", fields);
  };
  EXPECT_FALSE(inView(Json::object()).contains("problems"));
  EXPECT_FALSE(inView({{"view", "fup"}}).contains("problems"));
  EXPECT_EQ(inView({{"view", "kop"}})["problems"][0]["arguments"][1],
            "KOP kann das nicht darstellen: das Netzwerk wäre nur noch als FUP darstellbar");
  EXPECT_EQ(inView({{"view", "kop"}, {"language", "english"}})["problems"][0]["arguments"][1],
            "ladder cannot show this: only function blocks could show the network then");
}

// S7-EDIT-08
TEST(Networks, AreCopiedAndPasted) {
  Bench bench;
  const Json contact =
      bench.call("networks.copy", asked({{"network", 1}, {"elements", {{{"node", 1}}}}}))["lines"];
  EXPECT_EQ(contact, Json({"      U     E 0.1;"}));
  Json answer = edited(
      bench, {{"action", "paste"}, {"node", 3}, {"text", contact[0].get<std::string>() + "\n"}});
  EXPECT_EQ(answer["lines"].back(), "      U     E 0.1;");
  EXPECT_EQ(answer["node"], 5);
  const Json whole = bench.call("networks.copy", asked({{"network", 2}}))["lines"];
  EXPECT_EQ(whole, Json({"NETWORK", "      L     MW 2;", "      TAK   ;"}));
  answer = edited(bench, {{"action", "paste"}, {"text", "NETWORK\n L MW 2;\n TAK;"}});
  EXPECT_EQ(answer["lines"], Json({"NETWORK", " L MW 2;", " TAK;"}));
  EXPECT_EQ(answer["network"], 2);
  EXPECT_EQ(bench.problem("networks.copy", asked({{"network", 2}, {"elements", {{{"node", 0}}}}})),
            "P1308")
      << "it stays AWL";
  const Json nothing = {{"action", "paste"}, {"node", 0}, {"text", "TAK"}};
  EXPECT_EQ(bench.problem("networks.edit", asked({{"network", 1}, {"edit", nothing}})), "P1308");
}

TEST(Networks, AreMovedAndGetRungs) {
  Bench bench;
  Json answer =
      edited(bench, {{"action", "move"}, {"node", 1}, {"from", {{"network", 1}, {"node", 0}}}});
  EXPECT_EQ(answer["lines"][0], "      U     E 0.1;");
  EXPECT_EQ(answer["node"], 1);
  answer = edited(bench, {{"action", "move"}, {"from", {{"network", 2}}}, {"place", "before"}});
  EXPECT_EQ(answer["network"], 1);
  EXPECT_EQ(answer["lines"].back(), "      =     A 3.0;");
  answer = edited(bench, {{"action", "newRung"}});
  EXPECT_EQ(answer["lines"], Json({"      U     ??.?;", "      =     ??.?;"}));
  const Json nowhere = {{"action", "move"}, {"node", 1}};
  EXPECT_FALSE(bench.problem("networks.edit", asked({{"network", 1}, {"edit", nowhere}})).empty());
}

TEST(Networks, AreInsertedNamedAndDeleted) {
  Bench bench;
  Json answer = edited(bench, {{"action", "newNetwork"}, {"title", "Stop"}});
  EXPECT_EQ(answer["network"], 2);
  EXPECT_EQ(answer["from"], answer["to"]);
  answer = edited(bench, {{"action", "heading"}, {"title", "Run"}, {"comment", {"One", "Two"}}});
  EXPECT_EQ(answer["lines"], Json({"NETWORK", "TITLE = Run", "//One", "//Two"}));
  answer = edited(bench, {{"action", "deleteNetwork"}});
  EXPECT_EQ(answer["from"], 4);
  EXPECT_EQ(answer["to"], 11);
}

}  // namespace
}  // namespace merker::workbench::test
