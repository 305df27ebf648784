#include "s5d/kind.h"

#include <array>

namespace merker::s5d {
namespace {

using mc5::BlockType;

constexpr std::optional<BlockType> kNone{};

constexpr std::array kKinds{
    Kind{0x10, true, Group::Code, "OB", BlockType::Ob},
    Kind{0x04, true, Group::Code, "PB", BlockType::Pb},
    Kind{0x02, true, Group::Code, "SB", BlockType::Sb},
    Kind{0x08, true, Group::Code, "FB", BlockType::Fb},
    Kind{0x05, true, Group::Code, "FX", kNone},
    Kind{0x01, true, Group::Data, "DB", BlockType::Db},
    Kind{0x0C, true, Group::Data, "DX", kNone},
    Kind{0x51, true, Group::Comments, "OK", BlockType::Ob},
    Kind{0x31, true, Group::Comments, "PK", BlockType::Pb},
    Kind{0x21, true, Group::Comments, "SK", BlockType::Sb},
    Kind{0x41, true, Group::Comments, "FK", BlockType::Fb},
    Kind{0x5A, true, Group::Comments, "FKX", kNone},
    Kind{0x5B, true, Group::Comments, "DK", BlockType::Db},
    Kind{0x5C, true, Group::Comments, "DKX", kNone},
    Kind{0x64, true, Group::Document, "BB", kNone},
    Kind{0x06, false, Group::Formats, "DV", BlockType::Db},
    Kind{0x11, false, Group::Formats, "DVX", kNone},
    Kind{0x0D, false, Group::Labels, "FV", BlockType::Fb},
    Kind{0x0A, false, Group::Labels, "FVX", kNone},
};

}  // namespace

const Kind* kindAt(Bytes bytes) {
  const bool sync = byteAt(bytes, 0) == kSync && byteAt(bytes, 1) == kSync;
  const std::uint8_t mark = byteAt(bytes, sync ? kType : 0);
  for (const Kind& kind : kKinds)
    if (kind.sync == sync && kind.mark == mark) return &kind;
  return nullptr;
}

const Kind* kindOf(mc5::BlockType type, Group group) {
  for (const Kind& kind : kKinds)
    if (kind.block == type && kind.group == group) return &kind;
  return nullptr;
}

}  // namespace merker::s5d
