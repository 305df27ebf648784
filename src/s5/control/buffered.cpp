#include "control/buffered.h"

#include <algorithm>

#include "base/bytes.h"
#include "control/cnc.h"
#include "mc5/word_bytes.h"
#include "nc/number.h"

namespace merker::cnc {
namespace {

using Bytes = std::vector<std::uint8_t>;
using nc::Control;
using nc::Number;

// Numbers of the areas on the card: no data block has them.
constexpr std::uint16_t kProgramArea = 0x5005, kDataArea = 0x5006;
constexpr std::size_t kMostWords = 0x8000;  // of a segment

// Puts the buffered data of an NC one behind the other into bytes, or takes them out.
class Out {
 public:
  void whole(std::int32_t& value) { appendDWord(bytes, static_cast<std::uint32_t>(value)); }
  void byte(std::uint8_t& value) { bytes.push_back(value); }
  void number(Number& value) {
    whole(value.digits);
    bytes.push_back(value.places);
  }
  Bytes bytes;
};

class In {
 public:
  explicit In(const Bytes& bytes) : bytes_(bytes) {}
  void whole(std::int32_t& value) {
    if (const auto* at = take(4)) value = static_cast<std::int32_t>(loadDWord(at));
  }
  void byte(std::uint8_t& value) {
    if (const auto* at = take(1)) value = *at;
  }
  void number(Number& value) {
    whole(value.digits);
    byte(value.places);
    good_ = good_ && nc::makeNumber(value.digits, value.places).has_value();
  }
  bool complete() const { return good_ && next_ == bytes_.size(); }

 private:
  const std::uint8_t* take(std::size_t count) {
    good_ = good_ && bytes_.size() - next_ >= count;
    if (!good_) return nullptr;
    next_ += count;
    return bytes_.data() + next_ - count;
  }
  const Bytes& bytes_;
  std::size_t next_ = 0;
  bool good_ = true;
};

// In this order (docs/formats/card.md).
template <typename Way>
void passBuffered(Control& control, Way& way) {
  for (auto* words : {&control.machineData, &control.settingData})
    for (std::int32_t& word : *words) way.whole(word);
  for (auto* bytes : {&control.machineDataBytes, &control.settingDataBytes})
    for (std::uint8_t& byte : *bytes) way.byte(byte);
  for (auto& tool : control.tools)
    for (Number& value : tool) way.number(value);
  for (auto& channel : control.parameters)
    for (Number& value : channel) way.number(value);
  for (Number& value : control.centralParameters) way.number(value);
  for (auto& group : control.settable)
    for (nc::ZeroOffset& offset : group) {
      way.whole(offset.coarse);
      way.whole(offset.fine);
    }
  for (auto& group : control.programmable)
    for (nc::Count& count : group) way.whole(count);
  for (auto* offsets : {&control.external, &control.preset})
    for (nc::Count& count : *offsets) way.whole(count);
}

const Bytes* areaOf(const block::RetentiveData& data, std::uint16_t number) {
  for (const block::RetentiveDataBlock& block : data.dataBlocks)
    if (block.number == number) return &block.bytes;
  return nullptr;
}

bool isSegment(const Bytes* bytes) {
  return bytes != nullptr && bytes->size() % 2 == 0 && bytes->size() <= 2 * kMostWords;
}

}  // namespace

BlockId onCard(mc5::BlockId id) {
  const auto type = static_cast<unsigned>(id.type);
  return {BlockKind::FC, static_cast<std::uint16_t>(type << 8 | id.number)};
}

mc5::BlockId blockOf(BlockId id) {
  return {static_cast<mc5::BlockType>(id.number >> 8),
          static_cast<std::uint16_t>(id.number & 0xFF)};
}

const block::RetentiveData& Keeper::look(Cnc& control) {
  const sinumerik::Retained memory = control.plc().retained();
  data_.now = control.now().ns;
  data_.running = control.mode() != controller::Mode::Stop;
  data_.dataBlocks = {{kProgramArea, false, mc5::toBytes(memory.program)},
                      {kDataArea, false, mc5::toBytes(memory.data)}};
  if (seen_ && *seen_ == control.control()) return data_;
  seen_ = control.control();
  Out out;
  passBuffered(*seen_, out);
  data_.flags = std::move(out.bytes);
  return data_;
}

// A control that was in RUN starts as after a power failure: its mode before decides between warm
// and cold (S5-OB-02).
bool restore(Cnc& control, const block::RetentiveData& data) {
  const Bytes* program = areaOf(data, kProgramArea);
  const Bytes* words = areaOf(data, kDataArea);
  Control nc = control.control();
  In in(data.flags);
  passBuffered(nc, in);
  if (!isSegment(program) || !isSegment(words) || !in.complete()) return false;
  if (data.running) control.start();
  control.control() = std::move(nc);
  control.plc().restore({mc5::toWords(*program), mc5::toWords(*words)});
  return true;
}

}  // namespace merker::cnc
