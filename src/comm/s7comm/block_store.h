// What a server of S7 communication asks of a PLC's blocks. Rules of calls: plc.h.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "s7comm/pdu.h"

namespace merker::s7comm {

// A block by the character of its type and its number.
enum class BlockType : std::uint8_t {
  Ob = '8',
  Db = 'A',
  Sdb = 'B',
  Fc = 'C',
  Sfc = 'D',
  Fb = 'E',
  Sfb = 'F'
};

// Active: the program has it. Passive: it was loaded and waits to be linked into the program.
enum class FileSystem : std::uint8_t { Active = 'A', Both = 'B', Passive = 'P' };

struct BlockName {
  BlockType type = BlockType::Ob;
  std::uint16_t number = 0;
  FileSystem files = FileSystem::Active;
  bool operator==(const BlockName&) const = default;
};

struct BlockEntry {
  BlockType type = BlockType::Ob;
  std::uint16_t number = 0;
  std::uint8_t language = 0;  // as in its container (docs/formats/block.md)
};

class BlockStore {
 public:
  using Done = std::function<void(Error)>;
  using BlocksDone = std::function<void(const std::optional<std::vector<BlockEntry>>&)>;
  // The active ones, each type with ascending numbers. Nothing: it does not tell.
  virtual void blocks(BlocksDone done) = 0;
  using BlockDone = std::function<void(Error, const Bytes& container)>;
  // What its head says, and all of it.
  virtual void blockHead(const BlockName& name, BlockDone done) = 0;
  virtual void block(const BlockName& name, const std::string& password, BlockDone done) = 0;

  // Whether a block of so many octets may come, then the block: it is passive.
  virtual void admit(const BlockName& name, std::size_t octets, const std::string& password,
                     Done done) = 0;
  virtual void keep(const BlockName& name, Bytes container, const std::string& password,
                    Done done) = 0;
  // All of them or none, between two cycles: passive ones become active; blocks are deleted.
  virtual void link(const std::vector<BlockName>& names, const std::string& password,
                    Done done) = 0;
  virtual void remove(const std::vector<BlockName>& names, const std::string& password,
                      Done done) = 0;

 protected:
  BlockStore() = default;
  BlockStore(const BlockStore&) = default;
  BlockStore& operator=(const BlockStore&) = default;
  ~BlockStore() = default;
};

}  // namespace merker::s7comm
