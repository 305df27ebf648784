// Certificate and key of the server.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>
#include <string>

namespace merker::hmi {

// TLS 1.2 and later. Null, and the reason, if the files cannot be used.
std::unique_ptr<boost::asio::ssl::context> makeTls(const std::string& certificate,
                                                   const std::string& key, std::string& reason);

}  // namespace merker::hmi
