#include "serial_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <iostream>

#include "serial/serial_port.h"

namespace merker::app {
namespace {

using serial::Bytes;
using End = serial::Coupling::End;

constexpr std::size_t kMostUnsent = 65'536;
constexpr std::string_view kHeader = "time,event,characters";
// What a recording may be: a line has what the partner may send at a time, all of them a day's.
constexpr std::size_t kLongestLine = 2 * serial::Partner::kMost + 64, kMostRead = 512'000'000;

std::string hexadecimal(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += fmt::format("{:02X}", byte);
  return text;
}

bool readHexadecimal(std::string_view text, Bytes& bytes) {
  if (text.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(&text[i], &text[i] + 2, value, 16);
    if (error != std::errc{} || end != &text[i] + 2) return false;
    bytes.push_back(static_cast<std::uint8_t>(value));
  }
  return true;
}

// The lines of a file; one that is too long is not read to its end.
class Lines {
 public:
  explicit Lines(const std::string& name) : file_(name, std::ios::binary), buffer_(kLongestLine) {}
  // False: no more, or too long.
  bool next(std::string_view& line) {
    file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    const auto count = static_cast<std::size_t>(file_.gcount());
    ended_ = file_.eof() && count == 0;
    line = {buffer_.data(), file_.eof() || count == 0 ? count : count - 1};
    return static_cast<bool>(file_);
  }
  bool ended() const { return ended_; }  // nothing stands behind the last line

 private:
  std::ifstream file_;
  std::vector<char> buffer_;
  bool ended_ = false;
};

// Its frame is wrong on the line, too.
void sendFaulty(serial::Coupling& coupling, std::uint8_t value, Instant now) {
  const bool parity = coupling.parameters().line.frame.parity != serial::Parity::None;
  coupling.disturb(End::Partner, coupling.partner().queued(),
                   {.kind = parity ? serial::Fault::Kind::Parity : serial::Fault::Kind::Stop});
  coupling.partner().send({value}, now);
}

}  // namespace

std::unique_ptr<SerialLink> SerialLink::open(const serial::Connection& connection,
                                             const std::string& record, controller::Controller& plc,
                                             std::string& reason) {
  using Kind = serial::Connection::Kind;
  if (connection.kind == Kind::Partner) return nullptr;
  std::unique_ptr<SerialLink> link(new SerialLink(plc));
  serial::Coupling* const coupling = link->coupling();
  if (coupling == nullptr) {
    reason = "the project has no serial interface ([[module]] with slot = \"2.1\")";
    return nullptr;
  }
  if (connection.kind == Kind::Replay) {
    if (!link->readRecords(connection.place, reason)) return nullptr;
    return link;
  }
  link->stream_ = openStream(connection, coupling->parameters().line, reason);
  if (!link->stream_) return nullptr;
  if (record.empty()) return link;
  link->record_.open(record, std::ios::binary);
  link->record_ << kHeader << '\n';
  if (!link->record_) {
    reason = record + ": " + std::strerror(errno);
    return nullptr;
  }
  return link;
}

// time in ns, event, characters in hexadecimal digits
bool SerialLink::readRecord(std::string_view line) {
  constexpr std::string_view kKinds[] = {"in", "faulty", "cut", "connect"};
  const auto first = line.find(','), second = line.find(',', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return false;
  Record record;
  const char* const end = line.data() + first;
  const auto time = std::from_chars(line.data(), end, record.at.ns);
  const Instant before = records_.empty() ? Instant{} : records_.back().at;
  const auto* kind = std::ranges::find(kKinds, line.substr(first + 1, second - first - 1));
  if (time.ec != std::errc{} || time.ptr != end || record.at < before || kind == std::end(kKinds) ||
      !readHexadecimal(line.substr(second + 1), record.bytes))
    return false;
  record.kind = static_cast<Record::Kind>(kind - std::begin(kKinds));
  records_.push_back(std::move(record));
  return true;
}

bool SerialLink::readRecords(const std::string& name, std::string& reason) {
  Lines lines(name);
  std::string_view line;
  if (!lines.next(line) || line != kHeader) {
    reason = name + ": this is no recording of a serial line";
    return false;
  }
  std::size_t number = 2;
  for (std::size_t total = 0; lines.next(line); ++number) {
    total += line.size() + 1;
    if (total > kMostRead) {
      reason = fmt::format("{}:{}: the recording is longer than {} MB", name, number,
                           kMostRead / 1'000'000);
      return false;
    }
    if (!readRecord(line)) break;
  }
  if (lines.ended()) return true;
  reason = fmt::format("{}:{}: this is no line of a recording", name, number);
  return false;
}

serial::Coupling* SerialLink::coupling() {
  auto* port = controller::capability<serial::SerialPort>(plc_);
  return port == nullptr ? nullptr : port->serial();
}

Instant SerialLink::next() const {
  return played_ < records_.size() ? records_[played_].at : Instant::never();
}

void SerialLink::keep(const char* kind, const Bytes& bytes) {
  if (record_.is_open())
    record_ << plc_.now().ns << ',' << kind << ',' << hexadecimal(bytes) << std::endl;
}

void SerialLink::connect(serial::Coupling& coupling, bool connected) {
  if (connected == connected_) return;
  connected_ = connected;
  keep(connected ? "connect" : "cut", {});
  coupling.cut(End::Cpu, !connected, plc_.now());
  if (!connected) unsent_.clear();
}

void SerialLink::take(serial::Coupling& coupling) {
  SerialInput input;
  stream_->read(input, coupling.partner().room());
  Bytes good;
  const auto send = [&] {
    if (good.empty()) return;
    keep("in", good);
    coupling.partner().send(good, plc_.now());
    good.clear();
  };
  for (const SerialInput::Character& one : input.characters) {
    if (!one.faulty) {
      good.push_back(one.value);
      continue;
    }
    send();
    keep("faulty", {one.value});
    sendFaulty(coupling, one.value, plc_.now());
  }
  send();
  if (input.interrupted) connect(coupling, false);  // until the next exchange
}

// What nobody takes is lost at some time: the PLC does not wait, and memory has an end.
void SerialLink::give(serial::Coupling& coupling) {
  const Bytes fresh = coupling.partner().takeAll();
  if (!connected_) return;
  if (unsent_.size() + fresh.size() <= kMostUnsent)
    unsent_.insert(unsent_.end(), fresh.begin(), fresh.end());
  if (unsent_.empty()) return;
  const std::size_t count = std::min(stream_->write(unsent_), unsent_.size());
  unsent_.erase(unsent_.begin(), unsent_.begin() + static_cast<std::ptrdiff_t>(count));
}

void SerialLink::play(serial::Coupling& coupling, const Record& record) {
  using Kind = Record::Kind;
  if (record.kind == Kind::Cut || record.kind == Kind::Connect)
    coupling.cut(End::Cpu, record.kind == Kind::Cut, plc_.now());
  else if (record.kind == Kind::Faulty)
    for (const std::uint8_t byte : record.bytes) sendFaulty(coupling, byte, plc_.now());
  else
    coupling.partner().send(record.bytes, plc_.now());
}

void SerialLink::exchange() {
  serial::Coupling* const coupling = this->coupling();
  if (coupling == nullptr) return;
  if (stream_) {
    connect(*coupling, stream_->connected());
    give(*coupling);
    if (connected_) take(*coupling);
    if (const std::string notice = stream_->takeNotice(); !notice.empty())
      std::cerr << "serial interface X27: " << notice << std::endl;
  } else {
    coupling->partner().forget();
    for (; next() <= plc_.now(); ++played_) play(*coupling, records_[played_]);
  }
  coupling->advance(plc_.now());
}

}  // namespace merker::app
