// A probe of tests: notes what it sees, holds where it is told to.
#pragma once

#include <functional>
#include <vector>

#include "softplc/probe.h"

namespace merker::sinumerik {

struct Watcher : Probe {
  struct Seen {
    CodePlace place;
    Registers registers;
    bool blockEnded = false, levelEnded = false, trapped = false;
  };

  bool before(const Machine& m, const CodePlace& place) override {
    if (wanted && wanted(m, place)) return true;
    offsets.push_back(place.offset);
    return false;
  }
  void after(const Machine&, const CodePlace& place, const Passed& passed) override {
    done.push_back({place, passed.registers, passed.blockEnded, passed.levelEnded, passed.trapped});
  }

  // Once at this word.
  void holdAt(std::uint32_t offset) {
    wanted = [this, offset](const Machine&, const CodePlace& place) {
      if (place.offset != offset) return false;
      wanted = {};
      return true;
    };
  }
  std::vector<std::uint32_t> afterOffsets() const {
    std::vector<std::uint32_t> list;
    for (const Seen& one : done) list.push_back(one.place.offset);
    return list;
  }

  std::function<bool(const Machine&, const CodePlace&)> wanted;
  std::vector<std::uint32_t> offsets;  // executed
  std::vector<Seen> done;
};

using Offsets = std::vector<std::uint32_t>;
constexpr mc5::BlockId kIsOb1{mc5::BlockType::Ob, 1}, kIsOb2{mc5::BlockType::Ob, 2},
    kIsOb20{mc5::BlockType::Ob, 20}, kIsPb1{mc5::BlockType::Pb, 1}, kIsFb1{mc5::BlockType::Fb, 1};

}  // namespace merker::sinumerik
