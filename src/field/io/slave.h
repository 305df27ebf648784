// DP slaves of a station: each is a rack of its own behind the bus, with a head that talks to the
// master. Its modules stand with those of the CPU's racks, and have their terminals and faults.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/problem.h"
#include "io/configuration.h"

namespace merker::io {

struct Slave {
  std::uint8_t address = 0;
  std::string name, model;
  std::uint16_t ident = 0;                // of its GSD file
  std::uint16_t diagnosis = 0;            // its diagnostic address, an input byte
  std::uint8_t groups = 0;                // for SYNC and FREEZE: bit 0 is group 1
  bool sync = false, freeze = false;      // whether it knows the command
  std::uint32_t inputs = 0, outputs = 0;  // bytes of all its modules
  std::uint32_t head = 0;                 // slot of its head; modules of a GSD file count from 1
  std::vector<Module> modules;            // without the head
  Position position;
  bool intelligent = false;  // another station of the project, with areas to transfer as modules
};

// The DP interface of a station that is itself a slave: its side of the areas, in the same order.
struct OwnSlave {
  std::uint8_t master = 0;  // its address
  Slave self;
};

// Slots of an intelligent slave from here on are areas, in its master and in itself.
constexpr std::uint32_t kFirstArea = 4, kMostAreas = 32;

struct DpMaster {
  std::string subnet{};           // its name
  std::uint32_t highest = 126;    // address there (S7-NET-06)
  std::int64_t rate = 1'500'000;  // bit/s
  std::uint8_t address = 2;
  std::uint16_t diagnosis = 0;  // diagnostic address of the interface
  std::vector<Slave> slaves;    // in the order in which they lie on the line
};

// Racks from this number on are slaves: so much more than their address.
constexpr std::uint32_t kSlaveRack = 1000;
// The slot of the interface module of an ET 200M, in front of its modules; a station has the same.
constexpr std::uint32_t kHeadSlot = 2;

// The head has no order number: it is no module of the catalogue.
constexpr bool isHead(const ModuleType& type) {
  return type.kind == ModuleKind::Interface && type.orderNumber.empty();
}

// A module of a slave with so many bytes: up to four bytes each way are digital terminals, more are
// bytes only.
std::shared_ptr<const ModuleType> slaveModule(const std::string& name, std::uint32_t inputs,
                                              std::uint32_t outputs);

// The same without terminals: bytes that a drive reads and answers.
std::shared_ptr<const ModuleType> dataModule(const std::string& name, std::uint32_t inputs,
                                             std::uint32_t outputs);

// Adds the slaves to a configuration that is complete without them: modules without an address get
// one that is free, then all are checked together (S7-NET-04, -05).
void addSlaves(Configuration& configuration, DpMaster master, Problems& problems);
// The same for a station that is a slave: its master stands there as the head of its areas.
void addOwnSlave(Configuration& configuration, OwnSlave own, Problems& problems);

}  // namespace merker::io
