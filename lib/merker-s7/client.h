// What stands behind an S7Object.
#pragma once

#include <mutex>
#include <new>

#include "connection.h"
#include "merker_s7.h"

namespace merker::s7client {

struct Client {
  std::mutex lock;
  Settings settings;
  Connection connection;
  int lastError = 0;
};

// Runs `body(client)`; nothing is thrown into C.
template <typename Body>
int with(S7Object object, Body body) {
  if (object == 0) return errLibInvalidObject;
  auto& client = *reinterpret_cast<Client*>(object);
  const std::lock_guard guard(client.lock);
  try {
    return client.lastError = body(client);
  } catch (const std::bad_alloc&) {
    return client.lastError = errCliFunctionRefused;
  }
}

}  // namespace merker::s7client
