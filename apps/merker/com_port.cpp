#include "com_port.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace merker::app {
namespace {

using Bytes = std::vector<std::uint8_t>;

// RFC 854, RFC 855
constexpr std::uint8_t kSubEnd = 240, kSub = 250, kWill = 251, kWont = 252, kDo = 253, kDont = 254,
                       kCommand = 255;
// RFC 856, RFC 858, RFC 2217
constexpr std::uint8_t kBinary = 0, kNoGoAhead = 3, kComPort = 44;
// RFC 2217: what is set; the server answers with 100 more.
constexpr std::uint8_t kRate = 1, kDataBits = 2, kParity = 3, kStopBits = 4, kFlowControl = 5,
                       kLineStateMask = 10, kAnswer = 100, kLineState = 106;
constexpr std::uint8_t kNoFlowControl = 1, kBreak = 16;

constexpr std::size_t kLongestSub = 64;

constexpr bool isOurs(std::uint8_t option) {
  return option == kBinary || option == kNoGoAhead || option == kComPort;
}

Bytes rateOf(std::uint32_t baud) {
  return {static_cast<std::uint8_t>(baud >> 24), static_cast<std::uint8_t>(baud >> 16),
          static_cast<std::uint8_t>(baud >> 8), static_cast<std::uint8_t>(baud)};
}

// 1 none, 2 odd, 3 even: the order of serial::Parity.
std::uint8_t parityOf(serial::Parity parity) { return static_cast<std::uint8_t>(parity) + 1; }

}  // namespace

void ComPort::start() {
  state_ = State::Data;
  configured_ = told_ = false;
  sub_.clear();
  commands_.clear();
  for (const std::uint8_t option : {kBinary, kNoGoAhead, kComPort}) answer(kWill, option);
  for (const std::uint8_t option : {kBinary, kNoGoAhead}) answer(kDo, option);
}

void ComPort::encode(std::uint8_t character, Bytes& bytes) {
  if (character == kCommand) bytes.push_back(kCommand);
  bytes.push_back(character);
}

void ComPort::answer(std::uint8_t command, std::uint8_t number) {
  commands_.insert(commands_.end(), {kCommand, command, number});
}

void ComPort::tell(std::string text) {
  if (!std::exchange(told_, true)) notice_ = std::move(text);
}

std::string ComPort::takeNotice() { return std::exchange(notice_, {}); }

void ComPort::set(std::uint8_t what, Bytes value) {
  commands_.insert(commands_.end(), {kCommand, kSub, kComPort, what});
  for (const std::uint8_t byte : value) encode(byte, commands_);
  commands_.insert(commands_.end(), {kCommand, kSubEnd});
}

// The port as the interface is set, once for each connection.
void ComPort::configure() {
  if (std::exchange(configured_, true)) return;
  const serial::Frame& frame = settings_.frame;
  set(kRate, rateOf(settings_.baud));
  set(kDataBits, {frame.dataBits});
  set(kParity, {parityOf(frame.parity)});
  set(kStopBits, {frame.stopBits});
  set(kFlowControl, {kNoFlowControl});
  set(kLineStateMask, {kBreak});
}

// What was offered at the start is not answered again; nothing else is done or wanted.
void ComPort::option(std::uint8_t number) {
  if (command_ == kDo && number == kComPort) return configure();
  if (command_ == kDont && number == kComPort)
    return tell("the other side does not speak RFC 2217; its rate and frame are its own");
  if (command_ == kDo && !isOurs(number)) answer(kWont, number);
  if (command_ == kWill && number != kBinary && number != kNoGoAhead) answer(kDont, number);
}

void ComPort::notify(SerialInput& input) {
  if (sub_.size() < 3 || sub_[0] != kComPort) return;
  const Bytes value(sub_.begin() + 2, sub_.end());
  if (sub_[1] == kLineState && (value[0] & kBreak) != 0) input.interrupted = true;
  const serial::Frame& frame = settings_.frame;
  const std::pair<std::uint8_t, Bytes> wanted[] = {{kRate, rateOf(settings_.baud)},
                                                   {kDataBits, {frame.dataBits}},
                                                   {kParity, {parityOf(frame.parity)}},
                                                   {kStopBits, {frame.stopBits}}};
  constexpr const char* kNames[] = {"", "rate", "data bits", "parity", "stop bits"};
  for (const auto& [what, bytes] : wanted)
    if (sub_[1] == what + kAnswer && value != bytes)
      tell(
          fmt::format("the other side did not set its {} as the interface has them", kNames[what]));
}

bool ComPort::take(std::uint8_t byte, SerialInput& input) {
  switch (state_) {
    case State::Data:
      if (byte == kCommand)
        state_ = State::Command;
      else
        input.characters.push_back({byte});
      break;
    case State::Command:
      command_ = byte;
      if (byte == kCommand) input.characters.push_back({byte});
      sub_.clear();
      state_ = byte == kSub                     ? State::Sub
               : byte >= kWill && byte <= kDont ? State::Option
                                                : State::Data;
      break;
    case State::Option:
      option(byte);
      state_ = State::Data;
      break;
    case State::Sub:
      if (byte == kCommand)
        state_ = State::SubCommand;
      else if (sub_.size() < kLongestSub)
        sub_.push_back(byte);
      break;
    case State::SubCommand:
      if (byte == kCommand && sub_.size() < kLongestSub) sub_.push_back(byte);
      if (byte == kSubEnd) notify(input);
      state_ = byte == kCommand ? State::Sub : State::Data;
      break;
  }
  return commands_.size() <= kMostCommands;
}

}  // namespace merker::app
