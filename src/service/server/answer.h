// Answers to HTTP requests: the files of the page, or why not.
#pragma once

#include <boost/beast/http.hpp>

#include "server/guard.h"
#include "server/options.h"
#include "server/pages.h"

namespace merker::hmi {

namespace http = boost::beast::http;
using Request = http::request<http::string_body>;
// Its body lies in the program: an asset or the reason of a refusal. However many connections are
// answered, nobody holds a copy.
using Answer = http::response<http::span_body<const char>>;

// What is wrong with the request whatever it asks for; http::status::ok if nothing.
http::status refusal(const Request& request, const Guard& guard);
// The same of one that could not be read; ok: its sender has gone, or is too slow.
http::status refusal(boost::beast::error_code error);
Answer answer(const Request& request, const Guard& guard, std::span<const Asset> assets);
Answer refuse(const Request& request, http::status status);
// `page` outlives the answer.
Answer pageAnswer(const Request& request, const Page& page);
bool asksForWebSocket(const Request& request);

}  // namespace merker::hmi
