// --s7 [ADDRESS:]PORT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace merker::app {

struct S7Option {
  std::string place;  // as typed; empty: no S7 communication
};

struct S7Place {
  std::string address = "127.0.0.1";
  std::uint16_t port = 102;  // 0: any free one
};

void addS7(CLI::App& command, S7Option& option);
// Nothing, and the reason, if it is no place.
std::optional<S7Place> s7Place(const S7Option& option, std::string& reason);

}  // namespace merker::app
