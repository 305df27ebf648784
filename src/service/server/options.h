// Where the server listens, what it needs for that, and its limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "server/asset.h"

namespace merker::hmi {

struct Limits {
  std::size_t message = 4 << 20;   // bytes of one message
  std::size_t browsers = 64;       // open WebSockets
  std::size_t connections = 256;   // open sockets, WebSockets among them
  std::uint32_t header = 8 << 10;  // bytes of an HTTP header
  std::size_t waiting = 24 << 20;  // bytes that wait for a browser; beyond that it is given up
  unsigned request = 5;            // seconds for the first HTTP request, for TLS, for an upgrade
  unsigned idle = 20;              // seconds for a further request on the same connection
};

struct Options {
  std::string address = "127.0.0.1";  // or "localhost", which is the same
  std::uint16_t port = 8080;          // 0: any free one
  std::string token;                  // empty: none is asked for
  std::string certificate, key;       // PEM files; empty: no TLS
  std::span<const Asset> assets;
  Limits limits{};
};

// What is wrong with them; empty if nothing is. Beyond this machine token and TLS are needed; a
// token has 16 characters or more that an address can carry as they are.
std::string wrongOptions(const Options& options);

}  // namespace merker::hmi
