// A program printed and compiled again has the same words.
#include "compile.h"

namespace merker::step5 {
namespace {

TEST(Listing, ComesBack) {
  const auto first = compileText(R"(FB 5
NAME : TEST
BEZ : EIN E BI
BEZ : WERT D KG
BEZ : ZEIT T
NETZWERK 1 Anfang
     : U =EIN
     : LD =WERT
     : SPB =WEIT
     : L KT 10.2
     : SE =ZEIT
WEIT : NOP 0
NETZWERK 2 Ende
     : SU D 5.3
     : BE
OB 1
     : SPA FB 5
EIN  : M 30.0
WERT : KG +1234567+02
ZEIT : T 4
     : SPB PB 3
     : BE
PB 3
     : BE
DB 10
 KH 1F00
 KF -5
 KG +1000000+01
 KC A!
)");
  ASSERT_TRUE(first.ok());
  const std::string text = listing(first.program);
  const auto second = compileText(text);
  ASSERT_TRUE(second.ok()) << text;
  ASSERT_EQ(second.program.size(), first.program.size());
  for (const auto& [id, block] : first.program)
    EXPECT_EQ(second.program.at(id).words, block.words) << text;
}

}  // namespace
}  // namespace merker::step5
