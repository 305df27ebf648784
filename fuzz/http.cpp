// HTTP requests as bytes: whatever comes, the answer is one, only the server's own names get a
// file, and what was asked cannot end the header of the answer.
#include <boost/beast/http.hpp>
#include <sstream>

#include "harness.h"
#include "server/answer.h"

using namespace merker;
namespace http = boost::beast::http;

namespace {

constexpr hmi::Asset kAssets[] = {{"/index.html", "text/html", "1", "<p>page</p>"},
                                  {"/assets/a.js", "text/javascript", "2", "let a;"}};
constexpr std::size_t kMostLines = 40;  // of a header: ours and what it says of the page

void check(const hmi::Request& request, const hmi::Guard& guard) {
  const hmi::Answer answer = hmi::answer(request, guard, kAssets);
  const bool own = hmi::refusal(request, guard) == http::status::ok;
  fuzz::require(own || answer.result() != http::status::ok, "only its own names get a file");
  std::ostringstream text;
  text << answer.base();
  const std::string header = text.str();
  std::size_t lines = 0;
  for (const char c : header) lines += c == '\n' ? 1u : 0u;
  const auto fields = static_cast<std::size_t>(std::distance(answer.begin(), answer.end()));
  // The first line, a line for each field, an empty one.
  fuzz::require(lines == fields + 2 && lines < kMostLines, "a field is a line");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  http::request_parser<http::string_body> parser;
  parser.eager(true);
  parser.header_limit(hmi::Limits{}.header);
  parser.body_limit(hmi::Limits{}.header);
  boost::beast::error_code error;
  parser.put(boost::asio::const_buffer(data, size), error);
  if (!parser.is_header_done()) return 0;
  check(parser.get(), hmi::Guard(true, false, ""));
  check(parser.get(), hmi::Guard(false, true, "secret"));
  static_cast<void>(hmi::Guard(false, true, "secret")
                        .token({parser.get().target().data(), parser.get().target().size()}));
  static_cast<void>(hmi::asksForWebSocket(parser.get()));
  return 0;
}
