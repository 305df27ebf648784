// Load memory on the card: the blocks as containers (docs/formats/block.md), and for which CPU.
#pragma once

#include <string>
#include <vector>

#include "block/block.h"
#include "plc/buffered_memory.h"
#include "store/database.h"

namespace merker::store {

struct LoadMemory {
  std::string cpu;            // keyword of the model: "314C-2 PtP"
  std::string configuration;  // the text of merker.toml, as the system data blocks of a real card
  block::Program program;
};

// What a download did.
struct Download : controller::Renewal {
  bool anotherCpu = false;  // the card was that of another model, or empty
  bool changed() const {
    return anotherCpu || anotherConfiguration || !loaded.empty() || !deleted.empty();
  }
};

// Throws Damage if a block cannot be read.
LoadMemory readLoadMemory(Database& database);
// A row of `setting`; empty if it is missing. Throws Damage if its checksum is wrong.
std::string readSetting(Database& database, std::string_view name);
void writeSetting(Database& database, std::string_view name, const std::string& text);
// Brings the tables `block` and `setting` to this; blocks that are there already are left alone.
Download writeLoadMemory(Database& database, const LoadMemory& wanted);
// Of no use on a card (UDT), or why the card cannot hold it.
bool hasContainer(const block::Block& block);

}  // namespace merker::store
