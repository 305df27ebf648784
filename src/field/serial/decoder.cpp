#include "serial/decoder.h"

#include <fmt/format.h>

#include "serial/telegram.h"

namespace merker::serial {
namespace {

constexpr std::array<const char*, 32> kControls{
    "NUL", "SOH", "STX", "ETX", "EOT", "ENQ", "ACK", "BEL", "BS",   "HT",  "LF",
    "VT",  "FF",  "CR",  "SO",  "SI",  "DLE", "XON", "DC2", "XOFF", "DC4", "NAK",
    "SYN", "ETB", "CAN", "EM",  "SUB", "ESC", "FS",  "GS",  "RS",   "US"};

constexpr std::size_t kLongestBlock = 2'100;

// "SEND DB 10, byte 0, 4 bytes"
std::string commandText(const Command& command) {
  const LinkJob& job = command.job;
  const char* what = job.fetch ? "FETCH" : "SEND";
  if (command.followOn) return fmt::format("follow-on {}", what);
  if (command.event != Event::None)
    return fmt::format("{} that is wrong: {:04X}H", what, static_cast<unsigned>(command.event));
  std::string text =
      job.inBlock() ? fmt::format("{} D{} {}, byte {}, {} bytes", what, job.type == 'D' ? 'B' : 'X',
                                  job.block, job.offset, job.length)
                    : fmt::format("{} {} {}, {} bytes", what, job.type, job.offset, job.length);
  if (job.flag.used()) text += fmt::format(", flag {}.{}", job.flag.byte, job.flag.bit);
  return text;
}

std::string telegramText(const std::vector<std::uint8_t>& telegram) {
  if (isReaction(telegram)) {
    if (telegram.size() < 4) return "reaction telegram that is too short";
    const char* order = telegram[0] == 0xFF ? "follow-on reaction" : "reaction";
    return telegram[3] == 0 ? fmt::format("{}, no error, {} bytes", order, telegram.size() - 4)
                            : fmt::format("{}, error {:02X}H", order, telegram[3]);
  }
  return commandText(read(telegram));
}

}  // namespace

std::string characterName(std::uint8_t value) {
  if (value < kControls.size()) return kControls[value];
  if (value > 0x20 && value < 0x7F) return fmt::format("'{}'", static_cast<char>(value));
  return value == 0x20 ? "SP" : value == 0x7F ? "DEL" : "";
}

std::string Decoder::end() {
  state_ = State::Ended;
  if (protocol_ == Protocol::ComputerLink) return "; " + telegramText(data_);
  return fmt::format("; {} bytes", data_.size());
}

std::string Decoder::ofSender(std::uint8_t value) {
  switch (state_) {
    case State::Called:
    case State::Ended:
    case State::Idle:
      return value == Procedure::kNak ? "breaks off" : "unexpected";
    case State::Block:
      check_ ^= value;
      if (value == Procedure::kDle) return state_ = State::AfterDle, "";
      if (data_.size() < kLongestBlock) data_.push_back(value);
      return "";
    case State::AfterDle:
      check_ ^= value;
      state_ = State::Block;
      if (value == Procedure::kDle) return data_.push_back(value), "DLE of the data, doubled";
      if (value != Procedure::kEtx) return "neither DLE nor ETX after DLE";
      if (!blockCheck_) return "end of the block" + end();
      state_ = State::Check;
      return "end of the block";
    case State::Check:
      if (value != check_)
        return state_ = State::Ended, fmt::format("BCC wrong, {:02X} would be right", check_);
      return "BCC right" + end();
  }
  return {};
}

std::string Decoder::ofOther(std::uint8_t value) {
  const State before = state_;
  if (before == State::Called && value == Procedure::kDle) {
    state_ = State::Block;
    check_ = 0;
    data_.clear();
    return "connection is there";
  }
  if (before == State::Ended) {
    state_ = State::Idle;
    return value == Procedure::kDle ? "block acknowledged" : "block refused";
  }
  if (before == State::Called && value == Procedure::kStx) return "initialisation conflict";
  state_ = State::Idle;
  return value == Procedure::kNak ? "refused" : "disturbs";
}

std::string Decoder::meaning(const Sighting& sighting) {
  if (protocol_ == Protocol::Ascii) return {};
  const bool mine = sighting.port == sender_;
  const bool open = state_ == State::Block || state_ == State::AfterDle || state_ == State::Check;
  if (sighting.value == Procedure::kStx && !open && (mine || state_ != State::Called)) {
    sender_ = sighting.port;
    state_ = State::Called;
    return "wants to send";
  }
  if (state_ == State::Idle) return sighting.value == Procedure::kNak ? "ready" : "unexpected";
  return mine ? ofSender(sighting.value) : ofOther(sighting.value);
}

}  // namespace merker::serial
