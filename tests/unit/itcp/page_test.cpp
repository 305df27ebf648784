// Pages with places for values (S7-NET-16): where a place is, what it shows, and which file an
// address is.
#include <gtest/gtest.h>

#include "itcp/page_files.h"
#include "itcp/page_template.h"

namespace merker::itcp {
namespace {

using Names = std::vector<std::string>;

Names namesOf(std::string_view page) { return split(page).names; }

TEST(PageTemplate, NamesAreClosedByAColonOutsideQuotationMarks) {
  EXPECT_EQ(namesOf(":=MW 10:"), Names{"MW 10"});
  EXPECT_EQ(namesOf("a :=\"Lamp: red\": b :=\"Data\".level:"),
            (Names{"\"Lamp: red\"", "\"Data\".level"}));
  EXPECT_EQ(namesOf(":=a::=b:"), (Names{"a", "b"}));
}

TEST(PageTemplate, EverythingElseIsText) {
  for (const char* const page : {"", ":=", "::=", ":= ", ":= a:", ":=a",
                                 ":=a\n:", ":=a<b>:", ":=:", ":=\"a: b", "a := b; c := d"})
    EXPECT_EQ(namesOf(page), Names{}) << page;
  const std::string longName(PageTemplate::kLongestName + 1, 'x');
  EXPECT_EQ(namesOf(":=" + longName + ":"), Names{});
  EXPECT_EQ(namesOf(":=" + longName.substr(1) + ":").size(), 1u);
}

TEST(PageTemplate, MorePlacesThanAPageMayHaveStayText) {
  std::string page;
  for (std::size_t i = 0; i < PageTemplate::kMostNames + 3; ++i) page += ":=a:";
  const PageTemplate all = split(page);
  EXPECT_EQ(all.names.size(), PageTemplate::kMostNames);
  EXPECT_EQ(all.texts.back(), ":=a::=a::=a:");
}

TEST(PageTemplate, ValuesAreNothingButText) {
  const std::string page = "<p title=\":=a:\">:=b:</p>";
  const std::vector<PageValue> values = {{true, "\"'<&>\n\x7F"}, {false, "<no>"}};
  EXPECT_EQ(fill(split(page), values, Escape::Html),
            "<p title=\"&quot;&#39;&lt;&amp;&gt;  \">[&lt;no&gt;]</p>");
  EXPECT_EQ(fill(split("[\":=a:\", :=b:]"), values, Escape::Json), "[\"\\\"'<&>  \", null]");
}

TEST(PageFiles, ThePathOfAnAddress) {
  EXPECT_EQ(pathOf("/"), "index.html");
  EXPECT_EQ(pathOf("/?x"), "index.html");
  EXPECT_EQ(pathOf("/a/b%20c.css?x#y"), "a/b c.css");
  EXPECT_EQ(pathOf("/a/"), "a/index.html");
  for (const char* const wrong : {"", "x", "/../a", "/a/../b", "/%2e%2e/a", "/.a", "/a/.b", "//a",
                                  "/a//b", "/a%5cb", "/c:a", "/%", "/%4", "/%zz", "/%00"})
    EXPECT_FALSE(pathOf(wrong)) << wrong;
}

}  // namespace
}  // namespace merker::itcp
