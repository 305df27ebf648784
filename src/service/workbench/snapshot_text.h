// A CPU in a file: blocks, memory, images, clock (docs/formats/cpu-state.md). What a file contains
// is taken or refused, never trusted.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cpu/snapshot.h"
#include "monitor/monitor.h"
#include "workbench/json.h"

namespace merker::workbench {

struct SavedForce {
  std::string operand;
  std::string value;
};

struct SavedCpu {
  std::string model;                  // keyword
  std::vector<std::string> hardware;  // one line a module
  std::shared_ptr<const block::Program> program;
  cpu::Snapshot snapshot;
  std::vector<SavedForce> forces;
};

// What a CPU must be alike in to take a state.
std::vector<std::string> hardwareOf(const io::Rack* rack);

// P1308 if the text would be longer than `most`, P1008 for a block that has no container.
Result<std::string> snapshotText(const std::string& path, const SavedCpu& saved, std::size_t most);
// More than the text of a state may have.
Problem tooLong(const std::string& path, std::size_t most);
// `known`: programs whose blocks are taken, with their names and lines, where the file has the
// same. P1320.
Result<SavedCpu> parseSnapshot(const std::string& path, std::string_view text,
                               const std::vector<const block::Program*>& known);

}  // namespace merker::workbench
