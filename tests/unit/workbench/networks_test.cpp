#include "networks_bench.h"

namespace merker::workbench::test {
namespace {

// "contact 0", "coil 3": what has a symbol and can be selected.
std::vector<std::string> symbols(const Json& network) {
  std::vector<std::string> found;
  for (const Json& shape : network["shapes"])
    if (shape["kind"] == "contact" || shape["kind"] == "coil")
      found.push_back(shape["kind"].get<std::string>() + " " + shape["node"].dump());
  return found;
}

std::vector<std::string> operands(const Json& network) {
  std::vector<std::string> found;
  for (const Json& shape : network["shapes"])
    if (shape["kind"] == "text" && shape.contains("pin")) found.push_back(shape["text"]);
  return found;
}

// S7-EDIT-08
TEST(Networks, OfATextThatIsNotSavedAreShownAsLadder) {
  Bench bench;
  const Json answer = bench.call("networks.show", asked());
  EXPECT_EQ(answer["block"], "FC 1");
  EXPECT_EQ(answer["line"], 1);
  ASSERT_EQ(answer["networks"].size(), 2u);
  const Json& network = answer["networks"][0];
  EXPECT_EQ(network["view"], "kop");
  EXPECT_EQ(network["title"], "Start");
  EXPECT_EQ(network["comment"], " With self-holding");
  EXPECT_EQ(network["line"], 4);
  EXPECT_EQ(network["first"], 7);
  EXPECT_EQ(network["end"], 10);
  EXPECT_EQ(symbols(network),
            (std::vector<std::string>{"contact 0", "contact 1", "contact 2", "coil 3"}));
  EXPECT_EQ(network["sentences"][0], "A 3.0 = E 0.0 und E 0.1, oder A 1.0");
}

TEST(Networks, ThatStayAwlNameTheirStatement) {
  Bench bench;
  const Json network = bench.call("networks.show", asked())["networks"][1];
  EXPECT_EQ(network["view"], "awl");
  EXPECT_EQ(network["reasonLine"], 2) << "TAK, counted from NETWORK";
  EXPECT_FALSE(network["reason"].get<std::string>().empty());
}

// The instance stands above the box, its block inside; both are one operand for who types it.
TEST(Networks, ShowTheInstanceAboveTheBoxOfACall) {
  Bench bench;
  const Json network = bench.call("networks.show", asked({{"text", R"(FUNCTION FC 1 : VOID
BEGIN
NETWORK
      CALL FB 1, DB 1 ;
      NOP   0;
END_FUNCTION
)"}}))["networks"][0];
  std::map<std::string, Json> texts;
  Json frame;
  for (const Json& shape : network["shapes"]) {
    if (shape["kind"] == "text") texts[shape["text"]] = shape;
    if (shape["kind"] == "frame") frame = shape;
  }
  EXPECT_LT(texts["DB 1"]["y"], frame["y"]);
  EXPECT_GT(texts["FB 1"]["y"], frame["y"]);
  for (const char* part : {"FB 1", "DB 1"}) {
    EXPECT_EQ(texts[part]["written"], "FB 1, DB 1");
    EXPECT_EQ(texts[part]["pin"], 0);
  }
}

// Lines of a network count from its first one, so that it looks the same wherever it stands.
TEST(Networks, HaveWiresThatNameTheStatementsOfTheirSignal) {
  Bench bench;
  const Json network = bench.call("networks.show", asked())["networks"][0];
  bool coil = false;
  for (const Json& shape : network["shapes"]) {
    if (shape["kind"] != "wire") continue;
    for (const Json& flow : shape["flow"]) {
      EXPECT_GE(flow[0], 3);
      EXPECT_LE(flow[0], 6);
      coil = coil || (flow[0] == 5 && flow[1] == "vke");
    }
  }
  EXPECT_TRUE(coil) << "the VKE behind O A 1.0 goes to the coil";
}

TEST(Networks, SaveWordsWhereTheSignalIsNotKnown) {
  Bench bench;
  std::string text = kNetworks, branch;
  for (int i = 0; i < 100; ++i) branch += "      U     E 0.1;\n";
  text.insert(text.find("      O     A 1.0"), branch);
  const Json network = bench.call("networks.show", asked({{"text", text}}))["networks"][0];
  std::size_t unknown = 0;
  for (const Json& shape : network["shapes"])
    if (shape["kind"] == "wire" && !shape.contains("flow")) ++unknown;
  EXPECT_GT(unknown, 30u);
}

// "MW 10 at 4": operands whose value shows, with the line that moves it.
std::vector<std::string> values(const Json& network) {
  std::vector<std::string> found;
  for (const Json& shape : network["shapes"])
    if (shape.contains("value"))
      found.push_back(shape["text"].get<std::string>() + " at " + shape["value"].dump() +
                      (shape.contains("bcd") ? " bcd" : ""));
  return found;
}

// Each value is AKKU 1 behind the statement that moves it; of constants and blocks there is none.
// The wires at values carry no signal.
TEST(Networks, NameTheStatementsOfTheirValues) {
  Bench bench;
  const Json answer = bench.call("networks.show", asked({{"text", R"(FUNCTION FC 1 : VOID
BEGIN
NETWORK
      U     E 0.1;
      L     S5T#2S;
      SE    T 1;
      NOP   0;
      L     T 1;
      T     MW 20;
      LC    T 1;
      T     MW 22;
      U     T 1;
      =     A 4.4;
NETWORK
      U(;
      L     MW 10;
      L     5;
      ==I;
      );
      =     A 4.5;
NETWORK
      L     MW 2;
      T     MW 2;
      NOP   0;
NETWORK
      U     E 0.0;
      L     MW 6;
      SE    T 2;
END_FUNCTION
)"}}));
  using Texts = std::vector<std::string>;
  EXPECT_EQ(values(answer["networks"][0]), (Texts{"MW 20 at 6", "MW 22 at 8 bcd"}));
  EXPECT_EQ(values(answer["networks"][1]), (Texts{"MW 10 at 2"}));
  EXPECT_EQ(values(answer["networks"][2]), (Texts{"MW 2 at 1", "MW 2 at 2"}));
  EXPECT_EQ(values(answer["networks"][3]), (Texts{"MW 6 at 2"}));
  for (const Json& shape : answer["networks"][2]["shapes"])
    EXPECT_FALSE(shape["kind"] == "wire" && shape["h"] == 0 && shape["w"] == 1 &&
                 shape.contains("flow"))
        << shape;
}

// "#t S5TIME": what has a value, with its type where it is declared.
std::vector<std::string> types(const Json& network) {
  std::vector<std::string> found;
  for (const Json& shape : network["shapes"])
    if (shape.contains("value"))
      found.push_back(shape["text"].get<std::string>() + " " + shape.value("type", "-"));
  return found;
}

TEST(Networks, TellTheDeclaredTypesOfTheirValues) {
  const std::string program = std::string(kProgram) + R"(FUNCTION FC 1 : VOID
VAR_TEMP
  t : S5TIME;
  list : ARRAY [1..3] OF STRUCT
    a : REAL;
    n : INT;
  END_STRUCT;
END_VAR
BEGIN
NETWORK
      L     #t;
      T     #list[2].n;
      NOP   0;
NETWORK
      L     MW 20;
      T     "Counted";
      NOP   0;
NETWORK
      L     MD 30;
      T     #LIST[1].A;
      NOP   0;
END_FUNCTION
)";
  Bench bench(program);
  using Types = std::vector<std::string>;
  const Json networks =
      bench.call("networks.show", {{"file", "main.awl"}, {"line", 40}})["networks"];
  ASSERT_EQ(networks.size(), 3u);
  EXPECT_EQ(types(networks[0]), (Types{"#t S5TIME", "#list[2].n INT"}));
  EXPECT_EQ(types(networks[1]), (Types{"MW 20 INT", "\"Counted\" INT"})) << "by its symbol";
  EXPECT_EQ(types(networks[2]), (Types{"MD 30 -", "#LIST[1].A REAL"}));
}

TEST(Networks, NameTheParametersWhoseOperandsHaveAValue) {
  Bench bench;
  const Json network =
      bench.call("networks.show", asked({{"line", 15}, {"text", R"(FUNCTION FC 2 : VOID
VAR_INPUT
  x : INT;
END_VAR
VAR_OUTPUT
  y : INT;
END_VAR
BEGIN
NETWORK
      NOP   0;
END_FUNCTION
FUNCTION FC 1 : VOID
BEGIN
NETWORK
      U     E 0.0;
      SPBNB _001;
      CALL  FC 2 (
       x := MW 10,
       y := MW 12);
_001: NOP   0;
END_FUNCTION
)"}}))["networks"][0];
  std::vector<std::string> found;
  for (const Json& shape : network["shapes"])
    if (shape.contains("parameter"))
      found.push_back(shape["parameter"].get<std::string>() + " = " +
                      shape["text"].get<std::string>() + " at " + shape["value"].dump());
  EXPECT_EQ(found, (std::vector<std::string>{"x = MW 10 at 3", "y = MW 12 at 3"}));
}

TEST(Networks, OfStep5ShowNoValueOfAConstant) {
  Bench bench;
  bench.folder.write("main.s5",
                     "OB 1\nNETZWERK 1\n      U     E 0.0\n      L     KT 10.1\n      SE    T 1\n"
                     "      NOP 0\n      NOP 0\n      NOP 0\n      NOP 0\n"
                     "NETZWERK 2\n      U     E 0.1\n      L     MW 2\n      SE    T 2\n"
                     "      NOP 0\n      NOP 0\n      NOP 0\n      NOP 0\n      BE\n");
  bench.workbench.show(std::make_unique<Plc>(
      compilation::build(project::load(bench.folder.path("main.s5"), {}), false)));
  const Json answer = bench.call("networks.show", {{"file", "main.s5"}, {"line", 1}});
  ASSERT_EQ(answer["networks"].size(), 2u);
  for (const Json& network : answer["networks"]) EXPECT_EQ(network["view"], "kop");
  EXPECT_EQ(types(answer["networks"][0]), (std::vector<std::string>{}));
  EXPECT_EQ(types(answer["networks"][1]), (std::vector<std::string>{"MW 2 -"}));
}

TEST(Networks, ShowSymbolsOrAddressesButKnowWhatIsWritten) {
  Bench bench;
  const Json symbolic =
      bench.call("networks.show", asked({{"display", "symbolic"}}))["networks"][0];
  EXPECT_EQ(operands(symbolic), (std::vector<std::string>{"\"Start\"", "E 0.1", "A 1.0", "A 3.0"}));
  const auto start = std::ranges::find_if(
      symbolic["shapes"], [](const Json& shape) { return shape.value("text", "") == "\"Start\""; });
  EXPECT_EQ((*start)["written"], "E 0.0");
  std::string text = kNetworks;
  text.replace(text.find("E 0.0"), 5, "\"Start\"");
  const Json absolute =
      bench.call("networks.show", asked({{"text", text}, {"display", "absolute"}}))["networks"][0];
  EXPECT_EQ(operands(absolute).front(), "E 0.0");
}

// "SE T 1", and the pins of a box.
std::vector<std::string> names(const Json& network) {
  std::vector<std::string> found;
  for (const Json& shape : network["shapes"])
    if (shape.contains("text") && (shape["kind"] == "coil" || !shape.contains("node")))
      found.push_back(shape["text"]);
  return found;
}

// S7-MNE-03, S7-MNE-13: SE is an on-delay in German, an extended pulse in English.
TEST(Networks, NameElementsAsTheTextDoesInEachLanguageOfThePage) {
  Bench bench;
  const auto shown = [&](const std::string& body, const std::string& language) {
    const std::string text = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n" + body + "END_FUNCTION\n";
    return bench.call("networks.show", asked({{"text", text}, {"language", language}}));
  };
  const std::string german =
      "U E 0.0;\nL S5T#2S;\nSE T 1;\nU E 0.1;\nL S5T#2S;\nSE T 2;\n"
      "NOP 0;\nNOP 0;\nNOP 0;\nU T 2;\n= A 0.0;\n";
  const std::string english =
      "A I 0.0;\nL S5T#2S;\nSE T 1;\nA I 0.1;\nL S5T#2S;\nSE T 2;\n"
      "NOP 0;\nNOP 0;\nNOP 0;\nA T 2;\n= Q 0.0;\n";
  const std::vector<std::string> kGerman{"SE", "S", "TW", "R", "Q", "DUAL", "DEZ", "S_EVERZ"};
  const std::vector<std::string> kEnglish{"SE", "S", "TV", "R", "Q", "BI", "BCD", "S_PEXT"};
  for (const char* language : {"german", "english"}) {
    const Json one = shown(german, language), other = shown(english, language);
    EXPECT_EQ(one["mnemonics"], "german");
    EXPECT_EQ(other["mnemonics"], "international");
    EXPECT_EQ(names(one["networks"][0]), kGerman) << language;
    EXPECT_EQ(names(other["networks"][0]), kEnglish) << language;
  }
  const Json sentences = shown(german, "english")["networks"][0]["sentences"];
  EXPECT_EQ(sentences[0], "start T 1 as on-delay of S5T#2S with E 0.0")
      << "in the language of the page";
  EXPECT_EQ(sentences[1], "A 0.0 = S_EVERZ T 2 (S: E 0.1, TW: S5T#2S)");
}

TEST(Networks, WithoutStatementsHaveTheMnemonicsOfTheProject) {
  const char* kEmpty = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nEND_FUNCTION\n";
  Bench german, english(kProgram, "[program]\nmnemonics = \"english\"\n");
  const Json asking = asked({{"text", kEmpty}});
  EXPECT_EQ(german.call("networks.show", asking)["mnemonics"], "german");
  EXPECT_EQ(english.call("networks.show", asking)["mnemonics"], "international");
}

TEST(Networks, OfAFileAreReadFromTheDisk) {
  Bench bench;
  const Json answer = bench.call("networks.show", {{"file", "main.awl"}, {"line", 10}});
  EXPECT_EQ(answer["block"], "OB 1");
  EXPECT_EQ(bench.problem("networks.show", {{"file", "none.awl"}, {"line", 1}}), "P1310");
  EXPECT_EQ(bench.problem("networks.show", {{"file", "main.awl"}, {"line", 1}}), "P1308")
      << "a data block has no networks";
}

TEST(Networks, HaveTheElementsOfTheirFamily) {
  Bench bench;
  const auto find = [&](const std::string& id, const std::string& mnemonics = "german") -> Json {
    const Json answer = bench.call("networks.elements", {{"mnemonics", mnemonics}});
    for (const Json& element : answer["elements"])
      if (element["id"] == id) return element;
    return nullptr;
  };
  EXPECT_EQ(find("CONTACT")["key"], "F2");
  EXPECT_EQ(find("CONTACT")["fup"], "") << "FUP has inputs of gates";
  EXPECT_EQ(find("S_PULSE")["kop"], "S_IMPULS");
  EXPECT_EQ(find("S_PULSE", "international")["kop"], "S_PULSE");
  // SE is another timer in the other mnemonics; those names are told too.
  EXPECT_EQ(find("SD")["kop"], "(SE)");
  EXPECT_EQ(find("SD")["other"], Json({{"kop", "(SD)"}, {"fup", "SD"}}));
  EXPECT_EQ(find("SE", "international")["kop"], "(SE)");
  EXPECT_EQ(find("SE", "international")["other"], Json({{"kop", "(SV)"}, {"fup", "SV"}}));
  EXPECT_FALSE(find("S").contains("other"));
  EXPECT_EQ(find("COIL")["group"], "coil");
  // One JMP: what stands before it decides whether it is conditional.
  EXPECT_EQ(find("JMP")["kop"], "(JMP)");
  EXPECT_EQ(find("JMP_RAIL"), nullptr);
  EXPECT_EQ(find("CALL_RAIL"), nullptr);
  EXPECT_EQ(find("OPN")["kop"], "(OPN)");
  EXPECT_EQ(find("LABEL")["group"], find("JMP")["group"]);
}

}  // namespace
}  // namespace merker::workbench::test
