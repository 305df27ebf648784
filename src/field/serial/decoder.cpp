#include "serial/decoder.h"

#include <fmt/format.h>

#include <utility>

#include "serial/telegram.h"

namespace merker::serial {
namespace {

constexpr std::array<const char*, 32> kControls{
    "NUL", "SOH", "STX", "ETX", "EOT", "ENQ", "ACK", "BEL", "BS",   "HT",  "LF",
    "VT",  "FF",  "CR",  "SO",  "SI",  "DLE", "XON", "DC2", "XOFF", "DC4", "NAK",
    "SYN", "ETB", "CAN", "EM",  "SUB", "ESC", "FS",  "GS",  "RS",   "US"};

constexpr std::pair<std::uint8_t, const char*> kFaults[] = {{Character::kParity, "parity fault"},
                                                            {Character::kFrame, "frame fault"},
                                                            {Character::kOverrun, "overrun"}};

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

std::string nameOf(const Sighting& sighting) {
  return sighting.isCharacter() ? characterName(sighting.value) : "BREAK";
}

std::string faultsOf(const Sighting& sighting) {
  if (!sighting.isCharacter()) return "BREAK";
  std::string text;
  for (const auto& [fault, name] : kFaults)
    if ((sighting.faults & fault) != 0) text += (text.empty() ? "" : "; ") + std::string(name);
  return text;
}

std::string Decoder::end() {
  state_ = State::Ended;
  const char* const faulty = faulty_ ? ", faulty characters among them" : "";
  if (protocol_ == Protocol::ComputerLink) return "; " + telegramText(data_) + faulty;
  return fmt::format("; {} byte{}{}", data_.size(), data_.size() == 1 ? "" : "s", faulty);
}

// The block begins behind the DLE that answers STX.
std::string Decoder::open(const char* text) {
  state_ = State::Block;
  check_ = 0;
  faulty_ = false;
  data_.clear();
  return text;
}

std::string Decoder::ofSender(std::uint8_t value) {
  switch (state_) {
    case State::Called:
      if (conflict_ && value == Procedure::kDle) {  // the other one sends first
        sender_ = 1 - sender_;
        return open("gives way; connection is there");
      }
      [[fallthrough]];
    case State::Ended:
    case State::Failed:
    case State::Idle:
      if (value != Procedure::kNak) return "unexpected";
      return state_ = State::Idle, "breaks off";
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
  if (before == State::Called && value == Procedure::kDle) return open("connection is there");
  if (before == State::Ended) {
    const bool good = value == Procedure::kDle;
    state_ = good ? State::Idle : State::Failed;
    return good ? "block acknowledged" : "block refused";
  }
  if (before == State::Called && value == Procedure::kStx)
    return conflict_ = true, "initialisation conflict";
  state_ = State::Failed;
  return value == Procedure::kNak ? "refused" : "disturbs";
}

// NAK says that its sender is there, or refuses what nobody expected.
std::string Decoder::inIdle(const Sighting& sighting) {
  if (sighting.value != Procedure::kNak) return stray_ = true, "unexpected";
  return std::exchange(stray_, false) ? "refused" : "ready";
}

std::string Decoder::role(const Sighting& sighting) {
  const bool mine = sighting.port == sender_;
  const bool open = state_ == State::Block || state_ == State::AfterDle || state_ == State::Check;
  if (sighting.value == Procedure::kStx && !open && (mine || state_ != State::Called)) {
    sender_ = sighting.port;
    state_ = State::Called;
    conflict_ = stray_ = false;
    return "wants to send";
  }
  if (open) faulty_ = faulty_ || (mine && sighting.faults != 0);
  if (state_ == State::Idle) return inIdle(sighting);
  return mine ? ofSender(sighting.value) : ofOther(sighting.value);
}

std::string Decoder::meaning(const Sighting& sighting) {
  if (!sighting.isCharacter()) {
    state_ = State::Idle;
    stray_ = false;
    return sighting.kind == Sighting::Kind::Interrupted ? "BREAK begins" : "BREAK ends";
  }
  const std::string part = protocol_ == Protocol::Ascii ? "" : role(sighting);
  if (sighting.faults == 0) return part;
  return part.empty() ? faultsOf(sighting) : faultsOf(sighting) + "; " + part;
}

}  // namespace merker::serial
