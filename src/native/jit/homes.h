// Values that stand in memory anyway: bytes of an image that were loaded and that the region does
// not write, and bytes it writes that may be written at once, because each way out from here on
// writes them, or newer ones. Such a value leaves its register without a slot of the stack frame.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "jit/host.h"

namespace merker::jit {

class Homes {
 public:
  struct Home {
    icode::Space space;
    std::uint32_t byte;
    bool changed;  // it must be written first
  };
  explicit Homes(const icode::Region& region);

  // For a value that leaves its register while operation `now` is written. `isOver`: nobody needs
  // that value any more.
  std::optional<Home> take(icode::Value value, icode::Value now,
                           const std::function<bool(icode::Value)>& isOver);

  static std::uint32_t key(icode::Space space, std::uint32_t byte) {
    return static_cast<std::uint32_t>(space) << 24 | byte;
  }
  static host::Mem memory(std::uint32_t key) {
    return inImage(static_cast<icode::Space>(key >> 24), key & 0xFF'FFFF, 1);
  }

 private:
  struct Byte {
    std::uint32_t key = 0;
    icode::Value owner = icode::kNoValue;  // what stands there now, if it was written early
    icode::Value safeFrom = 0;             // all ways out from this operation on write it
  };
  bool noteStores(const icode::Region& region);
  void noteWrites(const icode::Region& region);
  void noteExits(const icode::Region& region);
  void findHomes(const icode::Region& region);
  std::optional<std::uint32_t> changedByte(const icode::Region& region, icode::Value value) const;

  Byte* written(std::uint32_t key);

  std::vector<Byte> written_;            // by key: bytes that ways out write
  std::vector<std::uint32_t> stored_;    // keys that operations write
  std::vector<std::uint32_t> homes_;     // by value, a key; kNone
  std::vector<std::uint32_t> writesOf_;  // by value: the one key it is written to
};

}  // namespace merker::jit
