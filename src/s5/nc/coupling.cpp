#include "nc/coupling.h"

#include <algorithm>

#include "mc5/instruction.h"
#include "nc/plc_memory.h"
#include "softplc/operand_access.h"

namespace merker::nc {
namespace {

using sinumerik::Alarm;
using sinumerik::Machine;
using sinumerik::Trap;

enum Message : std::uint8_t {
  kInterface = 1,
  kNoBlock = 2,
  kTooShort = 3,
  kInEprom = 4,
  kWordNumber = 5,
  kDirection = 6,
  kGood = 255
};
constexpr unsigned kFirstWord = 1, kLastWord = 126;
enum Direction : std::uint8_t { kToArea = 0, kToBlock = 1 };

bool isByte(const mc5::Operand& o) {
  const bool width =
      o.width == mc5::Width::Byte || o.width == mc5::Width::Left || o.width == mc5::Width::Right;
  return o.kind == mc5::OperandKind::Memory && width && o.area != mc5::Area::Peripheral;
}

// The byte that the word of the parameter list names; the list holds the code of "L AB 20".
std::optional<mc5::Operand> byteOperand(std::uint16_t word) {
  const auto decoded = mc5::decode({&word, 1});
  if (!decoded || decoded->instruction.operation != mc5::Operation::LOAD) return std::nullopt;
  if (!isByte(decoded->instruction.operand)) return std::nullopt;
  return decoded->instruction.operand;
}

bool wordsPermitted(unsigned first, unsigned count) {
  return first >= kFirstWord && count > 0 && first + count - 1 <= kLastWord;
}

}  // namespace

void Coupling::connect(std::shared_ptr<CouplingArea> area, Side side, std::function<void()> meet) {
  area_ = std::move(area);
  side_ = side;
  meet_ = std::move(meet);
}

std::optional<Trap> Coupling::transfer(Machine& m, std::span<const std::uint16_t> p) {
  const auto message = byteOperand(p[3]);
  if (!message) return Trap{Alarm::Substitution, {0, p[3], 0}};
  meet();
  if (area_ && area_->silent) return Trap{Alarm::NoAnswerCoupling, {}};
  if (sinumerik::write(m, *message, copy(m, p[1], p[2]))) return std::nullopt;
  return Trap{Alarm::TransferToMissingDb, {}};
}

std::uint8_t Coupling::copy(Machine& m, std::uint16_t place, std::uint16_t order) {
  const std::uint8_t first = lowByte(place), count = lowByte(order), number = highByte(place);
  const std::uint8_t direction = highByte(order);
  if (direction > kToBlock) return kDirection;
  if (!wordsPermitted(first, count)) return kWordNumber;
  if (!hasDataBlock(m, number)) return kNoBlock;
  const auto block = dataBlock(m, number);
  if (first + count > static_cast<int>(block.size())) return kTooShort;
  if (direction == kToBlock && m.dataInEprom.test(number)) return kInEprom;
  if (!area_ || area_->faulty) return kInterface;
  const auto inBlock = block.subspan(first, count);
  const auto inArea = std::span(area_->words).subspan(first, count);
  if (direction == kToArea)
    std::copy(inBlock.begin(), inBlock.end(), inArea.begin());
  else
    std::copy(inArea.begin(), inArea.end(), inBlock.begin());
  return kGood;
}

void Coupling::show(Partner state) {
  if (area_ && side_ == Side::Master) area_->master = state;
}

void Coupling::started() {
  meet();
  show(Partner::Runs);
}

void Coupling::stopped() {
  meet();
  if (area_ && area_->master == Partner::Runs) show(Partner::Failed);
}

bool Coupling::masterRuns() const {
  meet();
  return !area_ || side_ == Side::Master || area_->master != Partner::Failed;
}

}  // namespace merker::nc
