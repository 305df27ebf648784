// The modules of a DP slave as merker.toml names them.
#pragma once

#include <optional>

#include "gsd/device.h"
#include "io/slave.h"
#include "project/table.h"

namespace merker::project {

constexpr std::uint32_t kLongestData = 244;  // bytes each way in a telegram

// What a slave may have: modules, bytes of inputs, of outputs, of both.
struct SlaveLimits {
  std::int64_t modules, input, output, data;
};
// `parts`: what its modules are called in a problem.
void checkLengths(const Table& table, const io::Slave& slave, const SlaveLimits& limits,
                  std::string_view parts = "modules");

// The GSD file that `table` names; nothing after a problem.
std::optional<gsd::Device> readGsd(const Table& table);
io::Module moduleOf(const gsd::Module& module);
std::optional<io::Module> readGsdModule(const Table& table, const gsd::Device& device);
// A drive has one module, its telegram; its words are bytes without terminals.
std::optional<io::Module> readTelegram(const Table& table);

}  // namespace merker::project
