// PDUs of S7 communication, one behind the other: whatever comes, each answer is a PDU of at most
// the agreed length, nobody asks the PLC for more than that, and a job is answered once.
#include <optional>
#include <utility>

#include "harness.h"
#include "s7comm/partner.h"
#include "s7comm/request.h"

using namespace merker;
using s7comm::Bytes;
using s7comm::View;

namespace {

// Everything is there and 0; every third order is carried out later.
class Zeros : public s7comm::Plc {
 public:
  std::vector<std::function<void()>> waiting;

  void read(const std::vector<s7comm::Range>& ranges, ReadDone done) override {
    std::vector<s7comm::Value> values;
    std::size_t octets = 0;
    for (const s7comm::Range& range : ranges) {
      octets += range.octets;
      fuzz::require(octets <= s7comm::Offer{}.pdu, "no more is read than an answer holds");
      values.push_back({s7comm::ItemCode::Done, Bytes(range.octets)});
    }
    order([done = std::move(done), values = std::move(values)] { done(values); });
  }
  void write(std::vector<s7comm::Write> writes, WriteDone done) override {
    for (const s7comm::Write& one : writes)
      fuzz::require(one.octets.size() == one.range.octets, "a value is as long as its range");
    order([done = std::move(done), count = writes.size()] {
      done(std::vector(count, s7comm::ItemCode::Done));
    });
  }
  void status(std::uint16_t list, std::uint16_t index, StatusDone done) override {
    s7comm::StatusList found{s7comm::Error::None, 1, index, Bytes(index)};
    order([done = std::move(done), list, found = std::move(found)] {
      done(list % 2 == 0 ? s7comm::StatusList{} : found);
    });
  }
  void subscribe(const std::shared_ptr<s7comm::Outlet>& client, std::optional<std::uint8_t>,
                 s7comm::CyclicRead read, SubscribeDone done) override {
    std::vector<s7comm::Value> values;
    for (const s7comm::Range& range : read.ranges)
      values.push_back({s7comm::ItemCode::Done, Bytes(range.octets)});
    const Bytes data = read.data(values);
    fuzz::require(data.size() <= client->room(), "an indication fits the PDU");
    fuzz::require(read.milliseconds > 0, "there is time between two indications");
    client->send({.group = 2, .subfunction = read.subfunction, .octets = data});
    order([done = std::move(done), values = std::move(values)] {
      done(s7comm::Error::None, 1, values);
    });
  }
  void unsubscribe(const std::shared_ptr<s7comm::Outlet>& client, std::uint8_t,
                   s7comm::CyclicReads::Done done) override {
    client->deliver();
    order([done = std::move(done)] { done(s7comm::Error::None); });
  }
  void listen(const std::shared_ptr<s7comm::Outlet>&, std::uint8_t,
              s7comm::Messages::Done done) override {
    order([done = std::move(done)] { done(s7comm::Error::None); });
  }
  void acknowledge(std::vector<std::uint32_t> numbers, CodesDone done) override {
    order([done = std::move(done), count = numbers.size()] {
      done(std::vector(count, s7comm::ItemCode::Done));
    });
  }
  void lock(std::vector<std::uint32_t> numbers, bool, CodesDone done) override {
    acknowledge(std::move(numbers), std::move(done));
  }
  void alarms(AlarmsDone done) override {
    order([done = std::move(done)] {
      s7comm::AlarmState one{.number = 7, .comingValue = Bytes(12), .goingValue = Bytes(12)};
      done(std::vector(40, one));
    });
  }
  void clock(ClockDone done) override {
    order([done = std::move(done)] { done(s7comm::ClockTime{}); });
  }
  void enter(const std::string& password, Done done) override {
    order([done = std::move(done), good = !password.empty()] {
      done(good ? s7comm::Error::None : s7comm::Error::WrongPassword);
    });
  }
  void setClock(const s7comm::ClockTime& time, const std::string&, Done done) override {
    order([done = std::move(done), good = time[0] < 0x99] {
      done(good ? s7comm::Error::None : s7comm::Error::WrongTime);
    });
  }
  void blocks(BlocksDone done) override {
    order([done = std::move(done)] { done(std::vector<s7comm::BlockEntry>(200)); });
  }
  void blockHead(const s7comm::BlockName& name, BlockDone done) override {
    block(name, {}, std::move(done));
  }
  void block(const s7comm::BlockName& name, const std::string&, BlockDone done) override {
    const auto error = name.number % 2 == 0 ? s7comm::Error::NoSuchBlock : s7comm::Error::None;
    order([done = std::move(done), error] { done(error, Bytes(500)); });
  }
  void admit(const s7comm::BlockName& name, std::size_t octets, const std::string&,
             Done done) override {
    const auto error = octets > 2000 ? s7comm::Error::NoMemory : s7comm::Error::None;
    fuzz::require(name.files == s7comm::FileSystem::Passive, "what comes is passive");
    order([done = std::move(done), error] { done(error); });
  }
  void keep(const s7comm::BlockName&, Bytes container, const std::string&, Done done) override {
    fuzz::require(container.size() <= 2000, "no more is kept than was admitted");
    order([done = std::move(done)] { done(s7comm::Error::None); });
  }
  void link(const std::vector<s7comm::BlockName>& names, const std::string&, Done done) override {
    fuzz::require(!names.empty(), "somebody is linked");
    order([done = std::move(done)] { done(s7comm::Error::None); });
  }
  void remove(const std::vector<s7comm::BlockName>& names, const std::string& password,
              Done done) override {
    link(names, password, std::move(done));
  }
  void control(s7comm::Control wish, const std::string&,
               std::function<void(s7comm::Controlled)> done) override {
    order([done = std::move(done), wish] {
      done(static_cast<s7comm::Controlled>(static_cast<unsigned>(wish) % 4));
    });
  }
  // Every second job also says something.
  void test(s7comm::TestRequest request, std::shared_ptr<s7comm::Outlet> client,
            TestDone done) override {
    std::vector<s7comm::Value> values;
    for (const s7comm::TestItem& item : request.job.items) {
      fuzz::require(item.value.empty() || item.value.size() == item.range.octets ||
                        item.code != s7comm::ItemCode::Done,
                    "a value is as long as its range");
      values.push_back({item.code, Bytes(std::min<std::size_t>(item.range.octets, 4))});
    }
    if (request.other.number % 2 == 0)
      client->send({.group = 1, .octets = s7comm::testOctets(s7comm::statusData(values))});
    order([done = std::move(done), number = request.other.number, client] {
      if (client->announce()) client->deliver();
      done({number % 3 == 0 ? s7comm::Error::NoSuchJob : s7comm::Error::None, number, {}});
    });
  }

 private:
  void order(std::function<void()> what) {
    if (++orders_ % 3 != 0) return what();
    waiting.push_back(std::move(what));
  }
  unsigned orders_ = 0;
};

// What the PLC says unasked: userdata of type 0.
bool isIndication(View answer) { return answer.size() > 15 && answer[1] == 7 && answer[15] < 0x10; }

// A program with a receiving block, and one that sends and reads.
class FewJobs : public s7comm::PartnerProgram {
 public:
  void connected(bool) override {}
  void finished(s7comm::PartnerResult) override { ++results; }
  void begun(std::uint32_t, std::size_t octets) override {
    fuzz::require(octets < s7comm::kLongestTelegram, "what has begun is shorter than the longest");
  }
  void arrived(s7comm::Telegram telegram) override {
    ++telegrams;
    fuzz::require(telegram.octets.size() <= s7comm::kLongestTelegram, "a telegram has a limit");
  }
  void noticed(s7comm::Notice notice) override {
    fuzz::require(notice.areas.size() < 64, "areas fit a PDU");
  }
  std::size_t results = 0, telegrams = 0;
};

// The same PDUs as those of a partner: every job ends once, nothing is longer than agreed.
void hearPartner(View rest) {
  constexpr std::uint16_t kPdu = 240;
  FewJobs program;
  s7comm::Partner partner(program);
  partner.attach([](const Bytes& pdu) {
    fuzz::require(pdu.size() <= kPdu && s7comm::readPdu(pdu), "a partner gets a PDU as agreed");
  });
  partner.agreed(kPdu);
  partner.order({.receivers = {{0, true}, {.rid = 0, .enabled = true, .blocks = false}},
                 .jobs = {{.number = 1, .values = {Bytes(1000)}},
                          {.kind = s7comm::PartnerJob::Kind::Get, .number = 2, .items = {{}}}}});
  for (auto heard = s7comm::Partner::Heard::Done;
       !rest.empty() && heard != s7comm::Partner::Heard::Wrong;) {
    const std::size_t length = std::min<std::size_t>(rest[0], rest.size() - 1);
    heard = partner.receive(rest.subspan(1, length));
    rest = rest.subspan(1 + length);
  }
  fuzz::require(program.telegrams <= 1, "no second telegram before the first is taken");
  partner.detach();
  fuzz::require(program.results == 2, "a job ends once");
}

// What a client does with an answer.
void take(View answer, std::size_t most) {
  const auto pdu = s7comm::readPdu(answer);
  fuzz::require(pdu.has_value(), "an answer is a PDU");
  fuzz::require(answer.size() <= most, "an answer is as long as agreed");
  fuzz::require(pdu->parameters.size() + pdu->data.size() <= answer.size(), "its lengths are true");
  static_cast<void>(s7comm::setupAnswer(*pdu));
  if (const auto values = s7comm::readAnswer(*pdu))
    fuzz::require(!values->empty(), "values are read");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Zeros plc;
  View rest(data, size);
  hearPartner(rest);
  if (const auto pdu = s7comm::readPdu(rest)) {  // as an answer, too
    static_cast<void>(s7comm::setupAnswer(*pdu));
    static_cast<void>(s7comm::readAnswer(*pdu));
    static_cast<void>(s7comm::writeAnswer(*pdu));
  }
  std::size_t answers = 0, requests = 0;
  std::shared_ptr<s7comm::Session> session;
  session = std::make_shared<s7comm::Session>(plc, [&](const Bytes& pdu) {
    answers += isIndication(pdu) || pdu[1] == 1 ? 0u : 1u;  // 1: it is this side that asks
    take(pdu, s7comm::Offer{}.pdu);
  });
  bool good = true;
  while (good && !rest.empty()) {
    const std::size_t length = std::min<std::size_t>(rest[0], rest.size() - 1);
    const View pdu = rest.subspan(1, length);
    rest = rest.subspan(1 + length);
    if (session->busy())
      for (const auto& one : std::exchange(plc.waiting, {})) one();
    if (session->busy()) continue;
    good = session->receive(pdu);
    requests += good && pdu[1] != 2 && pdu[1] != 3 ? 1u : 0u;
  }
  while (!plc.waiting.empty())
    for (const auto& one : std::exchange(plc.waiting, {})) one();
  fuzz::require(answers == requests, "each request is answered once");
  return 0;
}
