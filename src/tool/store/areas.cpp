#include "store/areas.h"

#include <algorithm>

#include "base/bytes.h"
#include "store/database.h"

namespace merker::store {
namespace {

using block::RetentiveCounter;
using block::RetentiveData;
using block::RetentiveDataBlock;
using block::RetentiveEvent;
using block::RetentiveMeter;
using block::RetentiveTimer;

// A hundred years in nanoseconds: sums of two times cannot overflow.
constexpr std::int64_t kLongestTime = 3'155'760'000LL * 1'000'000'000;
constexpr std::uint8_t kHighestKind = 0x0F;  // of a block
constexpr std::size_t kMostEvents = 100, kMostMeters = 256, kMostOperands = 65'536;

void appendLong(Bytes& out, std::int64_t value) {
  appendDWord(out, static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) >> 32));
  appendDWord(out, static_cast<std::uint32_t>(value));
}

std::uint8_t bits(std::initializer_list<bool> values) {
  unsigned byte = 0, bit = 0;
  for (const bool value : values) byte |= static_cast<unsigned>(value) << bit++;
  return static_cast<std::uint8_t>(byte);
}

class Reader {
 public:
  explicit Reader(const Bytes& bytes) : bytes_(bytes) {}
  bool atEnd() const { return next_ == bytes_.size(); }
  std::uint8_t byte(unsigned highest = 0xFF) {
    const std::uint8_t value = *take(1);
    if (value > highest) throw Damage("a number is too high");
    return value;
  }
  std::uint16_t word() { return loadWord(take(2)); }
  std::uint32_t dword() { return loadDWord(take(4)); }
  std::int64_t time() {
    const std::uint64_t high = dword();
    const auto value = static_cast<std::int64_t>(high << 32 | dword());
    if (value < -kLongestTime || value > kLongestTime) throw Damage("a time is out of range");
    return value;
  }
  std::string text() {
    const std::size_t length = word();
    const auto* begin = reinterpret_cast<const char*>(take(length));
    return {begin, length};
  }

 private:
  const std::uint8_t* take(std::size_t count) {
    if (bytes_.size() - next_ < count) throw Damage("an area is cut off");
    next_ += count;
    return bytes_.data() + next_ - count;
  }
  const Bytes& bytes_;
  std::size_t next_ = 0;
};

RetentiveTimer readTimer(Reader& in) {
  RetentiveTimer timer;
  timer.kind = in.byte(4);
  const unsigned flags = in.byte(0xF);
  timer.startEdge = (flags & 1) != 0;
  timer.enableEdge = (flags & 2) != 0;
  timer.started = (flags & 4) != 0;
  timer.held = (flags & 8) != 0;
  timer.base = in.byte(3);
  timer.frozen = std::min<std::uint16_t>(in.word(), 999);
  timer.end = in.time();
  return timer;
}

RetentiveCounter readCounter(Reader& in) {
  RetentiveCounter counter;
  const unsigned flags = in.byte(0xF);
  counter.setEdge = (flags & 1) != 0;
  counter.upEdge = (flags & 2) != 0;
  counter.downEdge = (flags & 4) != 0;
  counter.enableEdge = (flags & 8) != 0;
  counter.count = std::min<std::uint16_t>(in.word(), 999);
  return counter;
}

RetentiveMeter readMeter(Reader& in) {
  RetentiveMeter meter;
  meter.running = in.byte(1) != 0;
  meter.counted = in.time();
  meter.since = in.time();
  return meter;
}

RetentiveEvent readEvent(Reader& in) {
  RetentiveEvent event;
  event.event = in.word();
  event.time = in.time();
  event.text = in.text();
  event.placeKnown = in.byte(1) != 0;
  event.block.kind = static_cast<BlockKind>(in.byte(kHighestKind));
  event.block.number = in.word();
  event.offset = in.dword();
  for (std::uint8_t& byte : event.info) byte = in.byte();
  for (std::uint8_t& byte : event.stamp) byte = in.byte();
  return event;
}

void readState(const Bytes& bytes, RetentiveData& data) {
  Reader in(bytes);
  data.now = in.time();
  data.clock = in.time();
  data.running = in.byte(1) != 0;
}

template <typename T>
void readAll(const Bytes& bytes, T (*readOne)(Reader&), std::size_t most, std::vector<T>& out) {
  Reader in(bytes);
  while (!in.atEnd()) {
    if (out.size() == most) throw Damage("an area is too long");
    out.push_back(readOne(in));
  }
}

}  // namespace

const AreaId kStateArea{"state", 0}, kFlagArea{"M", 0}, kTimerArea{"T", 0}, kCounterArea{"Z", 0},
    kMeterArea{"meters", 0}, kDiagnosticArea{"diagnostics", 0};

const std::set<AreaId>& areasOfEachCard() {
  static const std::set<AreaId> kAreas{kStateArea,   kFlagArea,  kTimerArea,
                                       kCounterArea, kMeterArea, kDiagnosticArea};
  return kAreas;
}

AreaId areaOf(const RetentiveDataBlock& block) {
  return {block.madeByProgram ? "made DB" : "DB", block.number};
}

Bytes stateBytes(const RetentiveData& data) {
  Bytes out;
  appendLong(out, data.now);
  appendLong(out, data.clock);
  out.push_back(data.running ? 1 : 0);
  return out;
}

Bytes timerBytes(const RetentiveData& data) {
  Bytes out;
  for (const RetentiveTimer& timer : data.timers) {
    out.push_back(timer.kind);
    out.push_back(bits({timer.startEdge, timer.enableEdge, timer.started, timer.held}));
    out.push_back(timer.base);
    appendWord(out, timer.frozen);
    appendLong(out, timer.end);
  }
  return out;
}

Bytes counterBytes(const RetentiveData& data) {
  Bytes out;
  for (const RetentiveCounter& counter : data.counters) {
    out.push_back(bits({counter.setEdge, counter.upEdge, counter.downEdge, counter.enableEdge}));
    appendWord(out, counter.count);
  }
  return out;
}

Bytes meterBytes(const RetentiveData& data) {
  Bytes out;
  for (const RetentiveMeter& meter : data.meters) {
    out.push_back(meter.running ? 1 : 0);
    appendLong(out, meter.counted);
    appendLong(out, meter.since);
  }
  return out;
}

Bytes diagnosticBytes(const RetentiveData& data) {
  Bytes out;
  for (const RetentiveEvent& event : data.events) {
    appendWord(out, event.event);
    appendLong(out, event.time);
    const std::string_view text = std::string_view(event.text).substr(0, 0xFFFF);
    appendWord(out, static_cast<std::uint32_t>(text.size()));
    out.insert(out.end(), text.begin(), text.end());
    out.push_back(event.placeKnown ? 1 : 0);
    out.push_back(static_cast<std::uint8_t>(event.block.kind));
    appendWord(out, event.block.number);
    appendDWord(out, event.offset);
    out.insert(out.end(), event.info.begin(), event.info.end());
    out.insert(out.end(), event.stamp.begin(), event.stamp.end());
  }
  return out;
}

RetentiveData fromAreas(const std::map<AreaId, Bytes>& areas) {
  RetentiveData data;
  for (const auto& [id, bytes] : areas) {
    if (id == kStateArea)
      readState(bytes, data);
    else if (id == kFlagArea)
      data.flags = bytes;
    else if (id == kTimerArea)
      readAll(bytes, readTimer, kMostOperands, data.timers);
    else if (id == kCounterArea)
      readAll(bytes, readCounter, kMostOperands, data.counters);
    else if (id == kMeterArea)
      readAll(bytes, readMeter, kMostMeters, data.meters);
    else if (id == kDiagnosticArea)
      readAll(bytes, readEvent, kMostEvents, data.events);
    else if (id.kind == "DB" || id.kind == "made DB")
      data.dataBlocks.push_back({id.number, id.kind == "made DB", bytes});
    else
      throw Damage("unknown area '" + id.kind + "'");
  }
  std::sort(data.dataBlocks.begin(), data.dataBlocks.end(),
            [](const auto& a, const auto& b) { return a.number < b.number; });
  return data;
}

}  // namespace merker::store
