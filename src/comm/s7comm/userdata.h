// Userdata: the services of programming devices, by group and subfunction, one row each.
#pragma once

#include "s7comm/services.h"

namespace merker::s7comm {

// The parameters of what a PLC says: as an answer, unasked, or to its partner.
struct UserdataHead {
  enum class Kind : std::uint8_t {
    Indication = 0x00,
    Request = 0x40,
    Answer = 0x80
  } kind = Kind::Answer;
  std::uint8_t group = 0, subfunction = 0, sequence = 0;
  std::uint8_t unit = 0;  // of an answer of several PDUs
  bool last = true;
  Error error = Error::None;
};

// Header, parameters and the head of the data.
constexpr std::size_t kUserdataOverhead = kHeader + 12 + 4;
Bytes writeUserdata(const UserdataHead& head, std::uint16_t reference, View octets);

// A request of userdata; what its answer needs is kept while the PLC works.
struct Request {
  Job job;
  std::uint8_t group = 0, subfunction = 0, sequence = 0;
  View data{};  // behind its head, while it is served

  void refuse(Error error) const;
  // All of it, in as many PDUs as it takes: the client asks for all but the first. A record is
  // never cut.
  void answer(Bytes octets, std::size_t record = 1) const;
  void done() const;                                                     // without data
  void whole(View octets) const { send(0, true, Error::None, octets); }  // they fit
  // The same, cut as said.
  void answerParts(const std::vector<Bytes>& parts) const;
  // In one PDU, with the number of a job for its sequence number.
  void answerAs(std::uint8_t number, View octets) const;

  // The PLC carries it out: what waits for its answer.
  Request begun() const;
  void ended() const { job.ended(); }

 private:
  friend void serveUserdata(const Job& job);
  void first(Rest rest) const;
  void next() const;
  void part(Rest& rest) const;
  void send(std::uint8_t unit, bool last, Error error, View octets) const;
};

struct UserdataService {
  std::uint8_t group, subfunction;
  const char* name;
  void (*serve)(const Request& request);
};

void serveMemoryReset(const Request& request);
void serveStatusList(const Request& request);
void serveReadClock(const Request& request);
void serveSetClock(const Request& request);
void serveEnterPassword(const Request& request);
void serveCancelPassword(const Request& request);
void serveSubscribe(const Request& request);
void serveModifySubscription(const Request& request);
void serveUnsubscribe(const Request& request);
void serveMessageService(const Request& request);
void serveAcknowledgeAlarms(const Request& request);
void serveLockAlarms(const Request& request);
void serveAlarmQuery(const Request& request);
void serveBlockCounts(const Request& request);
void serveBlockList(const Request& request);
void serveBlockInformation(const Request& request);
void serveTest(const Request& request);

}  // namespace merker::s7comm
