// How many blocks of each type there are, which, and what the head of one says.
#include <algorithm>

#include "base/bytes.h"
#include "s7comm/block_name.h"
#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

// As CPUs answer.
constexpr BlockType kTypes[] = {BlockType::Ob,  BlockType::Fb,  BlockType::Fc, BlockType::Db,
                                BlockType::Sdb, BlockType::Sfc, BlockType::Sfb};

Bytes counts(const std::vector<BlockEntry>& all) {
  Bytes octets;
  for (const BlockType type : kTypes) {
    octets.insert(octets.end(), {'0', static_cast<std::uint8_t>(type)});
    appendWord(octets,
               static_cast<std::uint32_t>(std::ranges::count(all, type, &BlockEntry::type)));
  }
  return octets;
}

constexpr std::size_t kListRecord = 4;

// As a CPU 315-2 PN/DP flags what was loaded and what is part of its operating system.
std::uint8_t flagsOf(BlockType type) {
  constexpr std::uint8_t kLoaded = 0x22, kOperatingSystem = 0x42;
  return type == BlockType::Sfc || type == BlockType::Sfb ? kOperatingSystem : kLoaded;
}

Bytes listOf(const std::vector<BlockEntry>& all, BlockType type) {
  Bytes octets;
  for (const BlockEntry& one : all) {
    if (one.type != type) continue;
    appendWord(octets, one.number);
    octets.insert(octets.end(), {flagsOf(type), one.language});
  }
  return octets;
}

// The head of the container up to the code, and its end behind the networks.
Bytes informationOf(BlockType type, const Bytes& container) {
  constexpr std::size_t kPart = 36;
  Bytes octets = {1, 0, 0, 2 + 2 * kPart, flagsOf(type), 0};
  octets.insert(octets.end(), container.begin(), container.begin() + kPart);
  octets.insert(octets.end(), container.end() - kPart, container.end());
  return octets;
}

}  // namespace

void serveBlockCounts(const Request& request) {
  request.job.plc().blocks(
      [begun = request.begun()](const std::optional<std::vector<BlockEntry>>& all) {
        all ? begun.answer(counts(*all)) : begun.refuse(Error::FunctionNotAvailable);
        begun.ended();
      });
}

void serveBlockList(const Request& request) {
  const auto type = request.data.size() == 2 ? blockTypeOf(request.data[1]) : std::nullopt;
  if (!type) return request.refuse(Error::NoBlocks);
  request.job.plc().blocks(
      [begun = request.begun(), type](const std::optional<std::vector<BlockEntry>>& all) {
        Bytes list = all ? listOf(*all, *type) : Bytes();
        const Error none = all ? Error::NoBlocks : Error::FunctionNotAvailable;
        list.empty() ? begun.refuse(none) : begun.answer(std::move(list), kListRecord);
        begun.ended();
      });
}

void serveBlockInformation(const Request& request) {
  const auto name = blockNameOf(request.data);
  if (!name) return request.refuse(Error::WrongBlockName);
  request.job.plc().blockHead(
      *name, [begun = request.begun(), type = name->type](Error error, const Bytes& container) {
        error == Error::None ? begun.answer(informationOf(type, container)) : begun.refuse(error);
        begun.ended();
      });
}

}  // namespace merker::s7comm
