// The other end of a serial line outside of the simulation: a pseudo terminal, a device of this
// computer, a TCP connection. Nothing here waits.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "serial/connection.h"
#include "serial/settings.h"

namespace merker::app {

// What a stream has to tell: characters, and what a serial device saw of their frames.
struct SerialInput {
  struct Character {
    std::uint8_t value = 0;
    bool faulty = false;
  };
  std::vector<Character> characters;
  bool interrupted = false;  // BREAK
};

class SerialStream {
 public:
  virtual ~SerialStream() = default;
  // Takes what has come, at most `most` characters.
  virtual void read(SerialInput& input, std::size_t most) = 0;
  // How many of them it took.
  virtual std::size_t write(const std::vector<std::uint8_t>& bytes) = 0;
  // Whether somebody is there; begins anew what was lost.
  virtual bool connected() = 0;
  // What a person should know of the other side, once; empty: nothing.
  virtual std::string takeNotice() { return {}; }
  virtual std::string name() const = 0;  // for people: "/dev/pts/3", "127.0.0.1:4000"
};

// Null, with the reason, if it cannot be opened.
std::unique_ptr<SerialStream> openStream(const serial::Connection& connection,
                                         const serial::Settings& settings, std::string& reason);

}  // namespace merker::app
