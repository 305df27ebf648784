// The client's side of RFC 2217: a serial port behind a telnet server. Its rate and frame are set
// there, BREAK comes back; everything else of telnet is refused (PTP-LINE-06).
#pragma once

#include <string>

#include "serial/settings.h"
#include "serial_stream.h"

namespace merker::app {

class ComPort {
 public:
  static constexpr std::size_t kMostCommands = 4'096;  // bytes of answers that wait to be sent

  explicit ComPort(const serial::Settings& settings) : settings_(settings) {}

  void start();  // a connection has begun
  // What has come: characters and BREAK. False: the other side asks for more than anybody does.
  bool take(std::uint8_t byte, SerialInput& input);
  // Commands that have to be sent, before any characters.
  std::vector<std::uint8_t>& commands() { return commands_; }
  // A character as it is sent.
  static void encode(std::uint8_t character, std::vector<std::uint8_t>& bytes);
  // What a person should know, once for each connection; empty: nothing.
  std::string takeNotice();

 private:
  enum class State : std::uint8_t { Data, Command, Option, Sub, SubCommand };
  void option(std::uint8_t number);
  void answer(std::uint8_t command, std::uint8_t number);
  void configure();
  void set(std::uint8_t what, std::vector<std::uint8_t> value);
  void notify(SerialInput& input);
  void tell(std::string text);

  serial::Settings settings_;
  State state_ = State::Data;
  std::uint8_t command_ = 0;
  std::vector<std::uint8_t> sub_, commands_;
  bool configured_ = false, told_ = false;
  std::string notice_;
};

}  // namespace merker::app
