// --s7 [ADDRESS:]PORT
#pragma once

#include <cstddef>
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
constexpr std::size_t kMostS7Stations = 64;  // each has a thread

// Of several stations: the place of the first one; nothing, and the reason is told, if the others
// have none behind it.
std::optional<S7Place> firstS7Place(const std::string& command, const S7Option& option,
                                    std::size_t stations);
// Of the station `number`; port 0 is any free one for each.
S7Option s7OptionOf(const S7Place& first, std::size_t number);

}  // namespace merker::app
