#include "itcp/smtp.h"

#include <fmt/format.h>

#include <charconv>

#include "itcp/escape.h"

namespace merker::itcp {
namespace {

constexpr std::size_t kDigits = 3;
constexpr unsigned kGreeting = 220, kDone = 250, kForwarded = 251, kGoOn = 354;

// The code of a reply; 0: it is none.
unsigned codeOf(std::string_view line) {
  unsigned code = 0;
  const std::string_view digits = line.substr(0, kDigits);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code);
  return digits.size() == kDigits && error == std::errc() && end == digits.data() + kDigits ? code
                                                                                            : 0;
}

// "250-more follows"
bool goesOn(std::string_view line) { return line.size() > kDigits && line[kDigits] == '-'; }

}  // namespace

std::string Smtp::refuse(std::string_view line) {
  state_ = State::Refused;
  reason_ = escaped(line.substr(0, kLongestReply), Escape::None);
  return "QUIT\r\n";
}

std::string Smtp::recipient() {
  step_ = Step::To;
  return fmt::format("RCPT TO:<{}>\r\n", letter_.to[addressed_++]);
}

// A point at the begin of a line is doubled (RFC 5321, 4.5.2); one alone ends the e-mail.
std::string Smtp::content() const {
  std::string out;
  bool begin = true;
  for (const char c : letter_.content) {
    if (begin && c == '.') out += '.';
    out += c;
    begin = c == '\n';
  }
  return out + ".\r\n";
}

std::string Smtp::hear(std::string_view line) {
  if (state_ != State::Talks) return {};
  const unsigned code = codeOf(line);
  if (code == 0 || ++replies_ > kMostReplies) return refuse(line);
  if (goesOn(line)) return {};
  std::string answer = next(code);
  return answer.empty() ? refuse(line) : answer;
}

// Nothing: this is no good answer to the step before.
std::string Smtp::next(unsigned code) {
  switch (step_) {
    case Step::Greeting:
      if (code != kGreeting) return {};
      step_ = Step::Hello;
      return fmt::format("EHLO {}\r\n", name_);
    case Step::Hello:
      if (code != kDone) {  // an old server (RFC 5321, 3.2)
        step_ = Step::OldHello;
        return fmt::format("HELO {}\r\n", name_);
      }
      [[fallthrough]];
    case Step::OldHello:
      step_ = Step::From;
      return code == kDone ? fmt::format("MAIL FROM:<{}>\r\n", letter_.from) : std::string();
    case Step::From:
      return code == kDone ? recipient() : std::string();
    case Step::To:
      if (code != kDone && code != kForwarded) return {};
      if (addressed_ < letter_.to.size()) return recipient();
      step_ = Step::Data;
      return "DATA\r\n";
    case Step::Data:
      step_ = Step::Content;
      return code == kGoOn ? content() : std::string();
    case Step::Content:
      if (code == kDone) state_ = State::Sent;
      return code == kDone ? "QUIT\r\n" : "";
  }
  return {};
}

}  // namespace merker::itcp
