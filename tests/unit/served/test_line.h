// A connection with the PLC behind it: PDUs of userdata, written by hand, and what comes back.
#pragma once

#include "../hex.h"
#include "base/bytes.h"
#include "s7comm/session.h"
#include "served_plc.h"

namespace merker::served {

class TestLine {
 public:
  explicit TestLine(ServedPlc& plc) : plc_(plc) {
    plc.exchange.opened();
    session_->receive(hex("32 01 00 00 00 01 00 08 00 00 F0 00 00 08 00 08 01 E0"));
    heard_.clear();
  }
  ~TestLine() {
    session_->end();
    plc_.exchange.closed();
  }
  TestLine(const TestLine&) = delete;

  // A request of group 1: the words of its parameters from the second on, and its data. What comes
  // back at the end of this cycle and of the next one.
  std::string ask(unsigned function, std::string_view parameters, std::string_view data) {
    send(function, parameters, data);
    plc_.cycles(1);
    return heard();
  }
  void send(unsigned function, std::string_view parameters, std::string_view data) {
    Bytes octets;
    const Bytes head = hex(parameters), tail = hex(data);
    appendWord(octets, static_cast<std::uint32_t>(head.size()));
    appendWord(octets, static_cast<std::uint32_t>(tail.size()));
    octets.insert(octets.end(), head.begin(), head.end());
    octets.insert(octets.end(), tail.begin(), tail.end());
    Bytes item = hex("FF 09");
    appendWord(item, static_cast<std::uint32_t>(octets.size()));
    item.insert(item.end(), octets.begin(), octets.end());
    Bytes pdu = hex("32 07 00 00 00 05 00 0C");
    appendWord(pdu, static_cast<std::uint32_t>(item.size()));
    for (const std::uint8_t one : hex("00 01 12 08 12 41")) pdu.push_back(one);
    pdu.insert(pdu.end(), {static_cast<std::uint8_t>(function), 0, 0, 0, 0, 0});
    pdu.insert(pdu.end(), item.begin(), item.end());
    session_->receive(pdu);
  }
  // Of each PDU: "type function number error: data", several with " | " between them.
  std::string heard() { return std::exchange(heard_, {}); }
  void receive(std::string_view pdu) { session_->receive(hex(pdu)); }

 private:
  void hear(const Bytes& pdu) {
    constexpr std::uint8_t kUserdata = 7;
    if (pdu[1] != kUserdata) return;  // the answer to the setup
    if (!heard_.empty()) heard_ += " | ";
    const auto p = std::span(pdu).subspan(10, 12);
    heard_ += p[5] >> 4 == 8 ? "answer " : "says ";
    heard_ += toHex(p.subspan(6, 2)) + ' ' + toHex(p.subspan(10, 2));
    if (pdu.size() > 34) heard_ += ": " + toHex(std::span(pdu).subspan(34));
  }

  ServedPlc& plc_;
  std::string heard_;
  std::shared_ptr<s7comm::Session> session_ =
      std::make_shared<s7comm::Session>(plc_.exchange, [this](const Bytes& pdu) { hear(pdu); });
};

// Words of parameters behind the first: how, how often, length, five ones, event.
inline std::string words(unsigned how, unsigned often, unsigned event) {
  const Bytes bytes = {0,
                       0,
                       0,
                       static_cast<std::uint8_t>(how),
                       0,
                       static_cast<std::uint8_t>(often),
                       0,
                       14,
                       0,
                       1,
                       0,
                       1,
                       0,
                       1,
                       0,
                       1,
                       0,
                       1,
                       static_cast<std::uint8_t>(event),
                       0};
  return toHex(bytes);
}

}  // namespace merker::served
