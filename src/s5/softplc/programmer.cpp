#include "softplc/programmer.h"

#include <fmt/format.h>

#include <array>

#include "mc5/resident_blocks.h"
#include "softplc/memory_size.h"
#include "softplc/segments.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockId;
using mc5::BlockType;
using mc5::kHeaderWords;

constexpr std::uint16_t kSegmentSwitch = 0xE000, kFineCode = 0xF000;
constexpr unsigned kPseudoAddresses = 0x17;
constexpr std::array kTypes{BlockType::Ob, BlockType::Pb, BlockType::Sb, BlockType::Fb,
                            BlockType::Db};

// F00C …: word addresses of the block lists in segment 1; F00F has none.
constexpr unsigned kFirstList = 0x0C;
constexpr std::array<std::uint32_t, 6> kLists{segment1::kObList, segment1::kFbList,
                                              segment1::kDbList, 0,
                                              segment1::kSbList, segment1::kPbList};

bool selectable(std::uint16_t segment) { return segment == 1 || segment == 5 || segment == 6; }

}  // namespace

bool Programmer::resident(BlockId id) const {
  return id.type == BlockType::Fb && os_.options().macros != nullptr &&
         os_.options().macros->has(id.number);
}

bool Programmer::system(BlockId id) const {
  return id.type == BlockType::Db && isSystemBlock(id.number, os_.options().systemBlocks);
}

std::optional<std::uint32_t> Programmer::status(const Reference& variable) const {
  return readValue(os_, variable);
}

std::string Programmer::control(const Reference& variable, std::uint32_t value) {
  if (std::string reason = whySystemOwned(os_, variable); !reason.empty()) return reason;
  if (writeValue(os_, variable, value)) return {};
  std::string reason = whyRefused(os_, variable);
  return reason.empty() ? "this operand does not exist" : reason;
}

std::uint16_t Programmer::pseudoAddress(unsigned index) const {
  const FineCode& fine = os_.record().fineCode();
  switch (index) {
    case 0:
      return fine.code;
    case 1:
      return fine.number;
    case 2:
    case 3:
    case 4:
      return fine.words[index - 2];
    case 5:
      return fine.delays;
    default:
      break;
  }
  const unsigned list = index - kFirstList;
  return list < kLists.size() ? static_cast<std::uint16_t>(kLists[list] / 2) : std::uint16_t{0};
}

std::optional<std::uint16_t> Programmer::address(std::uint16_t address) const {
  if (address == kSegmentSwitch) return os_.segmentSwitch;
  const unsigned index = address - kFineCode;
  if (index < kPseudoAddresses) return pseudoAddress(index);
  return readWord(os_.machine(), os_.segmentSwitch, address * 2u);
}

bool Programmer::correctAddress(std::uint16_t address, std::uint16_t value) {
  if (address == kSegmentSwitch) {
    if (selectable(value)) os_.segmentSwitch = static_cast<std::uint8_t>(value);
    return selectable(value);
  }
  if (address >= kFineCode) return false;
  return writeWord(os_.machine(), os_.segmentSwitch, address * 2u, value);
}

bool Programmer::hasRoom(const mc5::Block& block) const {
  const BlockMemory& blocks = os_.machine().blocks;
  const bool data = block.id.type == BlockType::Db;
  const Entry& old = blocks.find(block.id);
  const std::size_t freed = old.present ? old.length + kHeaderWords : 0;
  std::size_t used = (data ? blocks.dataUsed() : blocks.programUsed()) - freed;
  std::size_t room = data ? blocks.data().size() - kSystemDataWords : blocks.program().size();
  if (data)  // what the system's blocks take is kept for them
    for (const DirectoryEntry& entry : directory())
      if (system(entry.id)) used -= entry.words;
  return used + block.words.size() + kHeaderWords <= room;
}

std::string Programmer::load(const mc5::Block& block) {
  const BlockId id = block.id;
  if (resident(id)) return "Baustein bereits im EPROM (block is resident)";
  if (system(id)) return "70 DB im EPROM (DB belongs to the system)";
  const unsigned highest = id.type == BlockType::Ob ? 63 : 255;
  if (id.number > highest || (id.type == BlockType::Db && id.number == 0))
    return fmt::format("{} cannot be created", toString(id));
  if (id.type == BlockType::Db && block.words.size() > 2048)
    return fmt::format("{} has {} words, at most 2048", toString(id), block.words.size());
  if (!hasRoom(block)) return fmt::format("memory full, {} not loaded", toString(id));
  os_.betweenCycles([&os = os_, block] {
    os.machine().blocks.load(block);
    os.blocksChanged();
  });
  return {};
}

std::string Programmer::erase(BlockId id) {
  if (resident(id)) return "Baustein im EPROM (block is resident)";
  if (system(id)) return "70 DB im EPROM (DB belongs to the system)";
  if (!os_.machine().blocks.find(id).present) return fmt::format("{} is missing", toString(id));
  os_.betweenCycles([&os = os_, id] {
    os.machine().blocks.erase(id);
    os.blocksChanged();
  });
  return {};
}

std::optional<mc5::Block> Programmer::read(BlockId id) const {
  if (resident(id)) {  // name and parameters, no code (S5-FB-19)
    const mc5::Block* macro = mc5::findResident(id.number);
    return macro != nullptr ? std::optional(*macro) : std::nullopt;
  }
  const BlockMemory& blocks = os_.machine().blocks;
  const Entry& entry = blocks.find(id);
  if (!entry.present) return std::nullopt;
  const auto& memory = id.type == BlockType::Db ? blocks.data() : blocks.program();
  const std::uint16_t* body = memory.data() + entry.start;
  mc5::Block block;
  block.id = id;
  block.library = (body[-3] & 0xFFu) << 16 | body[-2];
  block.words.assign(body, body + entry.length);
  return block;
}

std::vector<DirectoryEntry> Programmer::directory() const {
  const auto offset = [this](BlockType type, bool resident) {
    return directoryOffset(os_.options(), *os_.options().machineData, type, resident);
  };
  std::vector<DirectoryEntry> entries;
  std::uint32_t macros = 0;  // in EPROM: a header and ASM each, one behind the other
  for (const BlockType type : kTypes) {
    const auto list = os_.machine().blocks.list(type);
    for (std::size_t n = 0; n < list.size(); ++n) {
      const BlockId id{type, static_cast<std::uint16_t>(n)};
      if (list[n].present)
        entries.push_back({id, list[n].start + offset(type, false), list[n].length + kHeaderWords});
      else if (resident(id))
        entries.push_back(
            {id, offset(type, true) + macros++ * (kHeaderWords + 1) + kHeaderWords, 0, true});
    }
  }
  return entries;
}

// Deleting leaves no gaps, so there is nothing to move; damaged memory ends it (SPABBR).
std::string Programmer::compress() {
  os_.record().set(ControlBit::SPABBR, false);
  os_.record().set(ControlBit::SCHTAE, true);
  os_.record().set(ControlBit::BSTSCH, true);
  os_.betweenCycles([&os = os_] {
    const bool damaged = os.machine().blocks.buildLists().has_value();
    os.record().set(ControlBit::SCHTAE, false);
    os.record().set(ControlBit::BSTSCH, false);
    os.record().set(ControlBit::SPABBR, damaged);
  });
  return os_.controlBits().test(ControlBit::SPABBR) ? "compression aborted, memory is damaged" : "";
}

std::optional<StopPicture> Programmer::stopPicture() const {
  return os_.mode() == Mode::Stop ? std::optional(os_.record().picture()) : std::nullopt;
}

std::string Programmer::controlBitText() const {
  const ControlBits bits = os_.controlBits();
  std::string text;
  for (unsigned byte = 1; byte <= 8; ++byte) {
    std::array<std::string, 8> cells;
    cells.fill("NB");
    for (const ControlBitRow& r : controlBitRows())
      if (r.byte == byte) cells[7 - r.bit] = fmt::format("{}={}", r.name, bits.test(r.id) ? 1 : 0);
    for (std::size_t i = 0; i < cells.size(); ++i) text += fmt::format("{:<11}", cells[i]);
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

}  // namespace merker::sinumerik
