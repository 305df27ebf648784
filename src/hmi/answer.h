// Answers to HTTP requests: the files of the page, or why not.
#pragma once

#include <boost/beast/http.hpp>

#include "hmi/guard.h"
#include "hmi/options.h"

namespace merker::hmi {

namespace http = boost::beast::http;
using Request = http::request<http::string_body>;
// The bytes of the assets live as long as the program.
using Answer = http::response<http::string_body>;

// What is wrong with the request whatever it asks for; http::status::ok if nothing.
http::status refusal(const Request& request, const Guard& guard);
Answer answer(const Request& request, const Guard& guard, std::span<const Asset> assets);
Answer refuse(const Request& request, http::status status);
bool asksForWebSocket(const Request& request);

}  // namespace merker::hmi
