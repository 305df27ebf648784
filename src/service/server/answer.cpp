#include "server/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/beast/websocket/rfc6455.hpp>

namespace merker::hmi {
namespace {

using http::field;
using http::status;

std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }

std::string_view pathOf(const Request& request) {
  const std::string_view target = view(request.target());
  const std::string_view path = target.substr(0, target.find_first_of("?#"));
  return path == "/" ? "/index.html" : path;
}

constexpr const char* kHeaders[][2] = {
    {"Server", "Merker"},
    {"X-Frame-Options", "DENY"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
};

// Nothing from anywhere else. Styles: the editor and the curves make some at run time. The
// WebSocket is named by its scheme because not every browser counts it among 'self'.
std::string contentPolicy(std::string_view host, bool tls) {
  return fmt::format(
      "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
      "connect-src 'self' {}://{}; object-src 'none'; base-uri 'none'; form-action 'none'; "
      "frame-ancestors 'none'",
      tls ? "wss" : "ws", host);
}

void setBody(Answer& result, std::string_view bytes) {
  result.body() = {bytes.data(), bytes.size()};
}

Answer blank(const Request& request, status code) {
  Answer result{code, request.version()};
  result.keep_alive(request.keep_alive());
  for (const auto& [name, value] : kHeaders) result.set(name, value);
  return result;
}

// Whether `Accept-Encoding: deflate, gzip;q=0.8` names gzip and does not refuse it.
bool takesGzip(std::string_view accepted) {
  for (std::size_t begin = 0; begin < accepted.size();) {
    const std::size_t end = std::min(accepted.find(',', begin), accepted.size());
    std::string one;
    for (const char c : accepted.substr(begin, end - begin))
      if (c != ' ' && c != '\t') one += c;
    if (one == "gzip" ||
        (one.starts_with("gzip;q=") && one.find_first_of("123456789", 7) != one.npos))
      return true;
    begin = end + 1;
  }
  return false;
}

// The names of everything under /assets/ change with its content.
bool neverChanges(std::string_view path) { return path.starts_with("/assets/"); }

Answer fileAnswer(const Request& request, const Guard& guard, const Asset& asset) {
  const bool packed = !asset.packed.empty() && takesGzip(view(request[field::accept_encoding]));
  const std::string tag = fmt::format("\"{}{}\"", asset.tag, packed ? "-gzip" : "");
  const bool known = view(request[field::if_none_match]) == tag;
  Answer result = blank(request, known ? status::not_modified : status::ok);
  result.set(field::etag, tag);
  result.set(field::cache_control,
             neverChanges(asset.path) ? "public, max-age=31536000, immutable" : "no-cache");
  result.set("Content-Security-Policy", contentPolicy(view(request[field::host]), guard.tls()));
  if (!asset.packed.empty()) result.set(field::vary, "Accept-Encoding");
  if (known) return result;
  result.set(field::content_type, std::string(asset.type));
  if (packed) result.set(field::content_encoding, "gzip");
  const std::string_view bytes = packed ? asset.packed : asset.bytes;
  result.content_length(bytes.size());
  if (request.method() != http::verb::head) setBody(result, bytes);
  return result;
}

}  // namespace

status refusal(const Request& request, const Guard& guard) {
  if (!guard.host(view(request[field::host]))) return status::misdirected_request;
  if (!guard.origin(view(request[field::origin]), view(request[field::host])))
    return status::forbidden;
  return status::ok;
}

status refusal(boost::beast::error_code error) {
  if (error == http::error::header_limit) return status::request_header_fields_too_large;
  if (error == http::error::body_limit) return status::payload_too_large;
  const bool wrong = error.category() == make_error_code(http::error::bad_line_ending).category() &&
                     error != http::error::end_of_stream && error != http::error::partial_message;
  return wrong ? status::bad_request : status::ok;
}

Answer refuse(const Request& request, status code) {
  Answer result = blank(request, code);
  result.set(field::content_type, "text/plain; charset=utf-8");
  if (code == status::method_not_allowed) result.set(field::allow, "GET, HEAD");
  const std::string_view text = view(http::obsolete_reason(code));
  result.content_length(text.size());
  if (request.method() != http::verb::head) setBody(result, text);
  return result;
}

// Pages of a user: their scripts and styles are theirs, and nothing comes from anywhere else. What
// they show is of this moment.
Answer pageAnswer(const Request& request, const Page& page) {
  Answer result = blank(request, static_cast<status>(page.status));
  result.set("X-Frame-Options", "SAMEORIGIN");
  result.set("Content-Security-Policy",
             "default-src 'self' 'unsafe-inline' data:; object-src 'none'; base-uri 'none'; "
             "form-action 'none'; frame-ancestors 'self'");
  result.set(field::cache_control, "no-store");
  result.set(field::content_type, page.type);
  result.content_length(page.bytes.size());
  if (request.method() != http::verb::head) setBody(result, page.bytes);
  return result;
}

Answer answer(const Request& request, const Guard& guard, std::span<const Asset> assets) {
  if (const status code = refusal(request, guard); code != status::ok) return refuse(request, code);
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return refuse(request, status::method_not_allowed);
  const auto found = std::ranges::find_if(
      assets, [path = pathOf(request)](const Asset& a) { return a.path == path; });
  return found == assets.end() ? refuse(request, status::not_found)
                               : fileAnswer(request, guard, *found);
}

bool asksForWebSocket(const Request& request) {
  return boost::beast::websocket::is_upgrade(request) && pathOf(request) == "/ws";
}

}  // namespace merker::hmi
