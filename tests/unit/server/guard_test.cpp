#include "server/guard.h"

#include <gtest/gtest.h>

#include "server/answer.h"

namespace merker::hmi {
namespace {

// A name that points to 127.0.0.1 is still another site's name.
TEST(Guard, KnowsItsOwnNames) {
  const Guard guard(true, false, "");
  for (const char* good : {"127.0.0.1", "127.0.0.1:8080", "localhost:9", "LOCALHOST", "[::1]:8080"})
    EXPECT_TRUE(guard.host(good)) << good;
  for (const char* bad :
       {"", "evil.example", "evil.example:8080", "127.0.0.1.evil.example", "localhost.evil.example",
        "[::1", "a b", "localhost\"", "127.0.0.1@evil", "[::1].evil", "[::1]evil:80",
        "localhost:evil", "localhost:80:80", "localhost:", "localhost:123456", ":80", "127.0.0.2"})
    EXPECT_FALSE(guard.host(bad)) << bad;
  EXPECT_TRUE(Guard(false, true, "x").host("plc.example:8443"));
  EXPECT_FALSE(Guard(false, true, "x").host("plc.example/;"));
}

TEST(Guard, TheAddressItListensToIsItsOwnName) {
  const Guard second(true, false, "", "127.0.0.2"), six(true, false, "", "::1");
  EXPECT_TRUE(second.host("127.0.0.2:8080"));
  EXPECT_TRUE(second.host("localhost"));
  EXPECT_FALSE(second.host("127.0.0.3"));
  EXPECT_TRUE(six.host("[::1]:8080"));
  EXPECT_FALSE(six.host("::1"));
}

TEST(Guard, ComparesTheOriginWithTheHost) {
  const Guard guard(true, false, "");
  EXPECT_TRUE(guard.origin("", "localhost:8080"));
  EXPECT_TRUE(guard.origin("http://localhost:8080", "localhost:8080"));
  for (const char* bad : {"http://evil.example", "http://localhost:8081", "https://localhost:8080",
                          "null", "http://localhost:8080.evil.example"})
    EXPECT_FALSE(guard.origin(bad, "localhost:8080")) << bad;
  EXPECT_TRUE(Guard(false, true, "x").origin("https://plc:1", "plc:1"));
}

TEST(Guard, WantsItsToken) {
  const Guard guard(false, true, "secret");
  EXPECT_TRUE(guard.token("/ws?token=secret"));
  EXPECT_TRUE(guard.token("/ws?a=b&token=secret&c=d"));
  for (const char* bad : {"/ws", "/ws?token=", "/ws?token=secre", "/ws?token=secret1",
                          "/ws?xtoken=secret", "/ws?token=Secret"})
    EXPECT_FALSE(guard.token(bad)) << bad;
  EXPECT_TRUE(Guard(true, false, "").token("/ws"));
}

TEST(Guard, KnowsWhatStaysOnThisMachine) {
  for (const char* local : {"127.0.0.1", "127.1.2.3", "::1", "localhost"})
    EXPECT_TRUE(isLocalAddress(local)) << local;
  for (const char* other : {"0.0.0.0", "::", "192.168.0.1", "localhost.example", ""})
    EXPECT_FALSE(isLocalAddress(other)) << other;
}

class Answers : public ::testing::Test {
 protected:
  Answer ask(http::verb method, const char* target, const char* host = "localhost:8080") {
    Request request{method, target, 11};
    request.set(http::field::host, host);
    if (!tag.empty()) request.set(http::field::if_none_match, tag);
    if (!origin.empty()) request.set(http::field::origin, origin);
    return answer(request, guard, assets);
  }
  static std::string_view body(const Answer& answer) {
    return {answer.body().data(), answer.body().size()};
  }
  Asset assets[2] = {{"/index.html", "text/html; charset=utf-8", "t1", "<p>"},
                     {"/assets/a.js", "text/javascript", "t2", "1;"}};
  Guard guard{true, false, ""};
  std::string tag, origin;
};

TEST_F(Answers, GiveTheFilesOfThePageOnly) {
  EXPECT_EQ(body(ask(http::verb::get, "/")), "<p>");
  EXPECT_EQ(body(ask(http::verb::get, "/?token=x")), "<p>");
  EXPECT_EQ(body(ask(http::verb::get, "/assets/a.js")), "1;");
  EXPECT_EQ(body(ask(http::verb::head, "/")), "");
  EXPECT_EQ(ask(http::verb::get, "/../etc/passwd").result(), http::status::not_found);
  EXPECT_EQ(ask(http::verb::get, "//index.html").result(), http::status::not_found);
  EXPECT_EQ(ask(http::verb::post, "/").result(), http::status::method_not_allowed);
  EXPECT_EQ(ask(http::verb::get, "/", "evil.example").result(), http::status::misdirected_request);
  origin = "http://evil.example";
  EXPECT_EQ(ask(http::verb::get, "/").result(), http::status::forbidden);
}

TEST_F(Answers, HoldNoCopyOfThePage) {
  const Answer page = ask(http::verb::get, "/"), again = page;
  EXPECT_EQ(static_cast<const void*>(page.body().data()), assets[0].bytes.data());
  EXPECT_EQ(static_cast<const void*>(again.body().data()), assets[0].bytes.data());
}

TEST_F(Answers, SayWhyNot) {
  EXPECT_EQ(body(ask(http::verb::get, "/nothing")), "Not Found");
  EXPECT_EQ(body(ask(http::verb::head, "/nothing")), "");
}

TEST_F(Answers, ProtectThePage) {
  const Answer page = ask(http::verb::get, "/");
  EXPECT_EQ(page["ETag"], "\"t1\"");
  EXPECT_EQ(page["X-Frame-Options"], "DENY");
  EXPECT_EQ(page["X-Content-Type-Options"], "nosniff");
  const std::string policy(page["Content-Security-Policy"]);
  EXPECT_NE(policy.find("default-src 'self'"), std::string::npos);
  EXPECT_NE(policy.find("connect-src 'self' ws://localhost:8080;"), std::string::npos);
  EXPECT_NE(policy.find("frame-ancestors 'none'"), std::string::npos);
}

TEST_F(Answers, KnowWhatTheBrowserHasAlready) {
  tag = "\"t1\"";
  EXPECT_EQ(ask(http::verb::get, "/").result(), http::status::not_modified);
  EXPECT_EQ(ask(http::verb::get, "/assets/a.js").result(), http::status::ok);
}

}  // namespace
}  // namespace merker::hmi
