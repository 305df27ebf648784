// The dialogue with a mail server (RFC 5321), line by line: one e-mail, without log-in and without
// encryption, as the CP does it.
#pragma once

#include <string>
#include <string_view>

#include "itcp/letter.h"

namespace merker::itcp {

class Smtp {
 public:
  static constexpr std::size_t kLongestReply = 1000, kMostReplies = 100;  // octets of a line; lines

  enum class State : std::uint8_t { Talks, Sent, Refused };

  // `name`: of this side, "[127.0.0.1]".
  Smtp(Letter letter, std::string name) : letter_(std::move(letter)), name_(std::move(name)) {}

  // A line of the server without its end; what is sent then, often nothing.
  std::string hear(std::string_view line);
  State state() const { return state_; }
  // What the server said when it refused.
  const std::string& reason() const { return reason_; }

 private:
  enum class Step : std::uint8_t { Greeting, Hello, OldHello, From, To, Data, Content };
  std::string next(unsigned code);
  std::string refuse(std::string_view line);
  std::string recipient();
  std::string content() const;

  Letter letter_;
  std::string name_, reason_;
  Step step_ = Step::Greeting;
  State state_ = State::Talks;
  std::size_t addressed_ = 0, replies_ = 0;
};

}  // namespace merker::itcp
