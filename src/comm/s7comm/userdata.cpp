#include "s7comm/userdata.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/bytes.h"
#include "s7comm/data_item.h"

namespace merker::s7comm {
namespace {

// group, subfunction, name
constexpr UserdataService kUserdataServices[] = {
    {1, 0x01, "block status", serveTest},
    {1, 0x02, "variable status", serveTest},
    {1, 0x03, "interrupt stack", serveTest},
    {1, 0x04, "block stack", serveTest},
    {1, 0x05, "local stack", serveTest},
    {1, 0x06, "time measurement", serveTest},
    {1, 0x07, "force selection", serveTest},
    {1, 0x08, "modify variables", serveTest},
    {1, 0x09, "force", serveTest},
    {1, 0x0A, "breakpoint", serveTest},
    {1, 0x0B, "exit HALT", serveTest},
    {1, 0x0C, "memory reset", serveMemoryReset},
    {1, 0x0D, "disable job", serveTest},
    {1, 0x0E, "enable job", serveTest},
    {1, 0x0F, "delete job", serveTest},
    {1, 0x10, "read job list", serveTest},
    {1, 0x11, "read job", serveTest},
    {1, 0x12, "replace job", serveTest},
    {1, 0x13, "program status", serveTest},
    {1, 0x16, "flash LED", serveTest},
    {2, 1, "subscribe", serveSubscribe},
    {2, 4, "unsubscribe", serveUnsubscribe},
    {2, 5, "subscribe on change", serveSubscribe},
    {2, 7, "modify a subscription", serveModifySubscription},
    {3, 1, "number of blocks", serveBlockCounts},
    {3, 2, "list of blocks", serveBlockList},
    {3, 3, "block information", serveBlockInformation},
    {4, 1, "read SZL", serveStatusList},
    {4, 2, "message service", serveMessageService},
    {4, 7, "lock messages", serveLockAlarms},
    {4, 8, "unlock messages", serveLockAlarms},
    {4, 0x0B, "acknowledge messages", serveAcknowledgeAlarms},
    {4, 0x13, "query messages", serveAlarmQuery},
    {5, 1, "enter password", serveEnterPassword},
    {5, 2, "cancel password", serveCancelPassword},
    {7, 1, "read clock", serveReadClock},
    {7, 2, "set clock", serveSetClock},
    {7, 3, "read clock", serveReadClock},
    {7, 4, "set clock", serveSetClock},
};

// 00 01 12, length, method, type and group, subfunction, sequence number.
constexpr std::size_t kUserdataHead = 8;
constexpr std::uint8_t kAnswerMethod = 0x12, kAnswerLength = 8;

bool isUserdata(View p) {
  return p.size() >= kUserdataHead && p[0] == 0 && p[1] == 1 && p[2] == kAnswerMethod &&
         p.size() - 4 >= p[3] && p[3] >= 4;
}

// The client wants the next part of an answer, and names it. Requests of group 1 look the same and
// name none.
bool wantsMore(View p) { return p[3] == kAnswerLength && p[4] == kAnswerMethod && p[7] != 0; }

}  // namespace

Bytes writeUserdata(const UserdataHead& head, std::uint16_t reference, View octets) {
  Bytes parameters = {0, 1, kAnswerMethod, kAnswerLength, kAnswerMethod};
  parameters.insert(
      parameters.end(),
      {static_cast<std::uint8_t>(static_cast<unsigned>(head.kind) | head.group), head.subfunction,
       head.sequence, head.unit, static_cast<std::uint8_t>(head.last ? 0 : 1)});
  appendWord(parameters, static_cast<std::uint32_t>(head.error));
  Bytes item;
  if (octets.empty())
    writeDataItem(item, {ItemCode::Missing, DataUnit::None, {}});
  else
    writeDataItem(item, {ItemCode::Done, DataUnit::Octets, octets});
  return writePdu({PduType::Userdata, reference, Error::None, parameters, item});
}

void Request::send(std::uint8_t unit, bool last, Error error, View octets) const {
  job.userdata({UserdataHead::Kind::Answer, group, subfunction, sequence, unit, last, error},
               octets);
}

void Request::refuse(Error error) const { send(0, true, error, {}); }
void Request::answerAs(std::uint8_t number, View octets) const {
  Request numbered = *this;
  numbered.sequence = number;
  numbered.send(0, true, Error::None, octets);
}

void Request::done() const { send(0, true, Error::None, {}); }

Request Request::begun() const {
  Request kept = *this;
  kept.job = job.begun();
  kept.data = {};
  return kept;
}

// Takes from `rest` what a PDU holds.
void Request::part(Rest& rest) const {
  const std::size_t most = job.pdu() - kUserdataOverhead;
  const std::size_t part = rest.parts.empty() ? most - most % rest.record : rest.parts.front();
  const std::size_t count = std::min({part, most, rest.octets.size()});
  if (!rest.parts.empty()) rest.parts.pop_front();
  const Bytes octets(rest.octets.begin(), rest.octets.begin() + static_cast<std::ptrdiff_t>(count));
  rest.octets.erase(rest.octets.begin(), rest.octets.begin() + static_cast<std::ptrdiff_t>(count));
  send(rest.unit, rest.octets.empty(), Error::None, octets);
}

void Request::answer(Bytes octets, std::size_t record) const {
  const bool whole = octets.size() + kUserdataOverhead <= job.pdu();
  first({.unit = whole ? std::uint8_t{0} : std::uint8_t{1},
         .octets = std::move(octets),
         .record = record});
}

void Request::answerParts(const std::vector<Bytes>& parts) const {
  Rest rest{.unit = parts.size() == 1 ? std::uint8_t{0} : std::uint8_t{1}};
  for (const Bytes& part : parts) {
    rest.octets.insert(rest.octets.end(), part.begin(), part.end());
    rest.parts.push_back(part.size());
  }
  first(std::move(rest));
}

// The unit of an answer in one PDU is 0, else the number of the answer.
void Request::first(Rest rest) const {
  Request numbered = *this;
  numbered.sequence = rest.sequence = job.rests().number();
  if (rest.unit != 0) rest.unit = rest.sequence;
  numbered.part(rest);
  if (!rest.octets.empty()) job.rests().keep(std::move(rest));
}

// Who asks for more than there is gets an empty last part.
void Request::next() const {
  Rests& rests = job.rests();
  Rest* const rest = rests.find(sequence);
  if (rest == nullptr) return rests.isLost(sequence) ? refuse(Error::NoInformation) : done();
  part(*rest);
  if (rest->octets.empty()) rests.end(sequence);
}

void serveUserdata(const Job& job) {
  const View p = job.parameters;
  if (!isUserdata(p)) return job.refuse(Error::WrongPduSize);
  Request request{.job = job,
                  .group = static_cast<std::uint8_t>(p[5] & 0x0F),
                  .subfunction = p[6],
                  .sequence = p[7]};
  if (wantsMore(p)) return request.next();
  const auto* const service =
      std::ranges::find_if(kUserdataServices, [&](const UserdataService& one) {
        return one.group == request.group && one.subfunction == request.subfunction;
      });
  View data = job.data;
  const auto item = readDataItem(data);
  if (service == std::end(kUserdataServices)) return request.refuse(Error::FunctionNotAvailable);
  if (!item) return request.refuse(Error::WrongPduSize);
  request.data = item->octets;
  service->serve(request);
}

}  // namespace merker::s7comm
