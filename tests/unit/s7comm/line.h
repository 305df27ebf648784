// A session over a PLC that is a few bytes, and PDUs as they are on the wire, written by hand.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "../hex.h"
#include "s7comm/session.h"

namespace merker::s7comm {

// 16 bytes of each area, DB 1 alone, timers and counters 0 to 7. What it is asked it does at once,
// or when it is told to.
class FewBytes : public Plc {
 public:
  using Key = std::pair<Memory, std::uint16_t>;
  std::map<Key, Bytes> memory{
      {{Memory::Peripheral, 0}, Bytes(16)}, {{Memory::Input, 0}, Bytes(16)},
      {{Memory::Output, 0}, Bytes(16)},     {{Memory::Flag, 0}, Bytes(16)},
      {{Memory::Timer, 0}, Bytes(16)},      {{Memory::Counter, 0}, Bytes(16)},
      {{Memory::DataBlock, 1}, Bytes(16)}};
  bool later = false;
  std::vector<std::function<void()>> waiting;
  std::size_t largest = 0;  // octets that were asked for at once

  void read(const std::vector<Range>& ranges, ReadDone done) override {
    std::vector<Value> values;
    for (const Range& range : ranges) values.push_back(value(range));
    carryOut([values = std::move(values), done = std::move(done)] { done(values); });
  }
  void write(std::vector<Write> writes, WriteDone done) override {
    carryOut([this, writes = std::move(writes), done = std::move(done)] {
      std::vector<ItemCode> codes;
      for (const Write& one : writes) codes.push_back(put(one));
      done(codes);
    });
  }
  // Jobs 1, 2 … of all clients; the last one that was asked for.
  std::map<std::uint8_t, CyclicRead> cyclic;
  void subscribe(const std::shared_ptr<Outlet>&, std::optional<std::uint8_t> job, CyclicRead wanted,
                 SubscribeDone done) override {
    const auto number = job.value_or(static_cast<std::uint8_t>(cyclic.size() + 1));
    std::vector<Value> values;
    for (const Range& range : wanted.ranges) values.push_back(value(range));
    const Error error = job && !cyclic.contains(*job) ? Error::NoSuchReading : Error::None;
    cyclic[number] = std::move(wanted);
    carryOut([=, done = std::move(done)] { done(error, number, values); });
  }
  void unsubscribe(const std::shared_ptr<Outlet>&, std::uint8_t job,
                   CyclicReads::Done done) override {
    const bool found = cyclic.erase(job) > 0;
    carryOut([found, done = std::move(done)] { done(found ? Error::None : Error::NoSuchReading); });
  }
  std::uint8_t listened = 0;
  void listen(const std::shared_ptr<Outlet>&, std::uint8_t kinds, Messages::Done done) override {
    listened = kinds;
    carryOut([done = std::move(done)] { done(Error::None); });
  }
  // Those there are; locked ones.
  std::vector<AlarmState> alarmList;
  std::map<std::uint32_t, bool> locked_;
  void acknowledge(std::vector<std::uint32_t> numbers, CodesDone done) override {
    std::vector<ItemCode> codes;
    for (const std::uint32_t number : numbers) {
      const bool found =
          std::ranges::find(alarmList, number, &AlarmState::number) != alarmList.end();
      codes.push_back(found ? ItemCode::Done : ItemCode::Missing);
    }
    carryOut([codes, done = std::move(done)] { done(codes); });
  }
  void lock(std::vector<std::uint32_t> numbers, bool on, CodesDone done) override {
    for (const std::uint32_t number : numbers) locked_[number] = on;
    carryOut([count = numbers.size(), done = std::move(done)] {
      done(std::vector(count, ItemCode::Done));
    });
  }
  void alarms(AlarmsDone done) override {
    carryOut([all = alarmList, done = std::move(done)] { done(all); });
  }
  // As many octets as are wished for.
  std::size_t listOctets = 8;
  void status(std::uint16_t list, std::uint16_t index, StatusDone done) override {
    StatusList found;
    if (list == 0x0011)
      found = {Error::None, 4, 2, Bytes(listOctets, static_cast<std::uint8_t>(index))};
    carryOut([found, done = std::move(done)] { done(found); });
  }
  std::optional<ClockTime> time = ClockTime{5, 9, 1, 8, 0, 0, 0, 5};
  void clock(ClockDone done) override {
    carryOut([this, done = std::move(done)] { done(time); });
  }
  std::string secret = "hidden";
  void enter(const std::string& password, Done done) override {
    const Error error = secret.empty()       ? Error::NoPassword
                        : password == secret ? Error::None
                                             : Error::WrongPassword;
    carryOut([error, done = std::move(done)] { done(error); });
  }
  void setClock(const ClockTime& now, const std::string&, Done done) override {
    carryOut([this, now, done = std::move(done)] {
      const bool good = now[1] <= 0x12;
      if (good) time = now;
      done(good ? Error::None : Error::WrongTime);
    });
  }
  // OB 1 and as many DBs as are wished for; a block is 36 octets of head, 300 of code, 36 behind
  // it.
  std::uint16_t dataBlocks = 2;
  void blocks(BlocksDone done) override {
    std::vector<BlockEntry> all = {{BlockType::Ob, 1, 2}};
    for (std::uint16_t i = 1; i <= dataBlocks; ++i) all.push_back({BlockType::Db, i, 5});
    carryOut([all, done = std::move(done)] { done(all); });
  }
  bool locked = false;  // without the password no upload, no download
  void blockHead(const BlockName& name, BlockDone done) override {
    block(name, secret, std::move(done));
  }
  void block(const BlockName& name, const std::string& password, BlockDone done) override {
    Bytes container(372, 0xCC);
    std::fill_n(container.begin(), 36, std::uint8_t{0xAA});
    std::fill_n(container.end() - 36, 36, std::uint8_t{0xEE});
    const bool found = name.type == BlockType::Ob && name.number == 1;
    const Error error = !found                         ? Error::NoSuchBlock
                        : locked && password != secret ? Error::NeedsPassword
                                                       : Error::None;
    carryOut([error, container, done = std::move(done)] { done(error, container); });
  }
  // Of blocks that come: not more than 1000 octets, and the first of them is 70h.
  std::vector<std::pair<BlockName, Bytes>> kept;
  void admit(const BlockName&, std::size_t octets, const std::string& password,
             Done done) override {
    const Error error = locked && password != secret ? Error::NeedsPassword
                        : octets > 1000              ? Error::NoMemory
                                                     : Error::None;
    carryOut([error, done = std::move(done)] { done(error); });
  }
  void keep(const BlockName& name, Bytes container, const std::string&, Done done) override {
    const Error error = container[0] == 0x70 ? Error::None : Error::WrongBlockStructure;
    if (error == Error::None) kept.emplace_back(name, std::move(container));
    carryOut([error, done = std::move(done)] { done(error); });
  }
  std::vector<BlockName> linked, removed;
  void link(const std::vector<BlockName>& names, const std::string&, Done done) override {
    linked = names;
    const Error error = kept.empty() ? Error::NoSuchBlock : Error::None;
    carryOut([error, done = std::move(done)] { done(error); });
  }
  void remove(const std::vector<BlockName>& names, const std::string&, Done done) override {
    removed = names;
    carryOut([done = std::move(done)] { done(Error::None); });
  }
  bool runs = true;
  void control(Control wish, const std::string&, std::function<void(Controlled)> done) override {
    carryOut([this, wish, done = std::move(done)] {
      if (wish == Control::ColdRestart) return done(Controlled::Refused);
      if (wish == Control::Compress) return done(Controlled::Done);
      if (wish >= Control::CopyRamToRom) return done(runs ? Controlled::Refused : Controlled::Done);
      const bool already = runs == (wish == Control::WarmRestart);
      runs = wish == Control::WarmRestart;
      done(already ? Controlled::Already : Controlled::Done);
    });
  }
  // Group 1: what was asked last, and a short answer with the number 9.
  TestRequest tested;
  Error testError = Error::None;
  void test(TestRequest request, std::shared_ptr<Outlet>, TestDone done) override {
    tested = std::move(request);
    carryOut([this, done = std::move(done)] { done({testError, 9, {}}); });
  }
  void carryOutAll() {
    for (const auto& one : std::exchange(waiting, {})) one();
  }

 private:
  void carryOut(std::function<void()> order) {
    if (later) return waiting.push_back(std::move(order));
    order();
  }
  std::uint8_t* place(const Range& range) {
    largest = std::max<std::size_t>(largest, range.octets);
    const auto found = memory.find({range.memory, range.block});
    if (found == memory.end()) return nullptr;
    const std::size_t begin = range.begin * (isCell(range.memory) ? 2u : 1u);
    return begin + range.octets <= 16 ? &found->second[begin] : nullptr;
  }
  ItemCode whyNot(const Range& range) const {
    return memory.contains({range.memory, range.block}) ? ItemCode::OutOfRange : ItemCode::Missing;
  }
  Value value(const Range& range) {
    const std::uint8_t* const bytes = place(range);
    if (bytes == nullptr) return {whyNot(range), {}};
    if (range.oneBit) return {ItemCode::Done, {static_cast<std::uint8_t>(*bytes >> range.bit & 1)}};
    return {ItemCode::Done, Bytes(bytes, bytes + range.octets)};
  }
  ItemCode put(const Write& one) {
    std::uint8_t* const bytes = place(one.range);
    if (bytes == nullptr) return whyNot(one.range);
    const auto mask = static_cast<std::uint8_t>(1u << one.range.bit);
    if (one.range.oneBit)
      *bytes = static_cast<std::uint8_t>(one.octets[0] != 0 ? *bytes | mask : *bytes & ~mask);
    else
      std::copy(one.octets.begin(), one.octets.end(), bytes);
    return ItemCode::Done;
  }
};

class Line {
 public:
  explicit Line(bool setUp = true) {
    if (setUp) say("32 01 00 00 00 01 00 08 00 00 F0 00 00 08 00 08 01 E0");
  }
  // What comes back; several PDUs with " | " between them.
  std::string say(std::string_view pdu) { return say(hex(pdu)); }
  std::string say(const Bytes& pdu) {
    good = session->receive(pdu);
    return heard();
  }
  std::string heard() { return std::exchange(answers_, {}); }

  FewBytes plc;
  bool good = true;
  std::shared_ptr<Session> session = std::make_shared<Session>(plc, [this](const Bytes& pdu) {
    if (!answers_.empty()) answers_ += " | ";
    answers_ += toHex(pdu);
  });

 private:
  std::string answers_;
};

}  // namespace merker::s7comm
