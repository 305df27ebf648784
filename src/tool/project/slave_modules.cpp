// The modules of a slave: of its GSD file, or the telegram of a drive (S7-NET-04 to -06,
// S7-NET-22).
#include "project/slave_modules.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/text.h"
#include "gsd/configuration.h"
#include "gsd/read.h"
#include "plant/telegram.h"
#include "project/files.h"

namespace merker::project {
namespace {

std::string moduleNames(const gsd::Device& device) {
  constexpr std::size_t kShown = 10;
  std::string list;
  for (std::size_t i = 0; i < device.modules.size() && i < kShown; ++i)
    list += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", device.modules[i].name);
  return device.modules.size() > kShown ? list + ", …" : list;
}

void readStart(const Table& table, std::string_view key, bool has,
               std::optional<std::uint32_t>& start, Position& position) {
  const auto address = table.number(key, 0, 65'535);
  if (!address) return;
  if (!has) return table.mustBe(key, "omitted; the module has no such bytes");
  start = *address;
  position = table.at(key);
}

std::string telegramNames() {
  std::string list;
  for (const plant::Telegram* telegram : plant::telegrams())
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", telegram->name);
  return list;
}

}  // namespace

void checkLengths(const Table& table, const io::Slave& slave, const SlaveLimits& limits,
                  std::string_view parts) {
  std::int64_t input = 0, output = 0;
  for (const io::Module& module : slave.modules)
    input += module.type->inputBytes, output += module.type->outputBytes;
  const auto most = [&](std::int64_t is, std::int64_t limit, std::string_view what) {
    if (is > limit)
      table.mustBe("modules", fmt::format("at most {} {}; these are {}", limit, what, is));
  };
  most(static_cast<std::int64_t>(slave.modules.size()), limits.modules,
       limits.modules == 1 ? "module" : parts);
  most(input, limits.input, "bytes of inputs");
  most(output, limits.output, "bytes of outputs");
  most(input + output, limits.data, "bytes in all");
}

std::optional<gsd::Device> readGsd(const Table& table) {
  const auto name = table.text("gsd", "the name of a GSD file");
  if (!name) return std::nullopt;
  const std::string path = join(folderOf(table.place().file), *name);
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file || !isFile(path) || size > gsd::kLargestFile) {
    table.mustBe("gsd", fmt::format("a GSD file of at most 1 MB; {} cannot be read", path));
    return std::nullopt;
  }
  std::string bytes(size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  gsd::Reading reading = gsd::read(gsd::decode(path, std::move(bytes)));
  if (reading.isGsd) return std::move(reading.device);
  table.mustBe("gsd", "a GSD file; this one has no line #Profibus_DP");
  return std::nullopt;
}

io::Module moduleOf(const gsd::Module& module) {
  const gsd::Areas areas = gsd::readIdentifiers(module.configuration);
  io::Module made;
  made.own = io::slaveModule(module.name, std::min(areas.input(), kLongestData),
                             std::min(areas.output(), kLongestData));
  made.type = made.own.get();
  made.parameters = io::Parameters::of(*made.type);
  return made;
}

std::optional<io::Module> readGsdModule(const Table& table, const gsd::Device& device) {
  table.allow({"slot", "type", "input", "output", "name"});
  const auto type = table.text("type", "the name of a module in the GSD file");
  if (!table.has("type"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "type = " + moduleNames(device));
  if (!type) return std::nullopt;
  const auto found = std::ranges::find_if(device.modules, [&](const gsd::Module& module) {
    return equalsIgnoreCase(module.name, trim(*type));
  });
  if (found == device.modules.end()) {
    table.mustBe("type", "the name of a module in the GSD file: " + moduleNames(device));
    return std::nullopt;
  }
  io::Module module = moduleOf(*found);
  module.position = table.place();
  module.name = table.text("name", "a text").value_or("");
  readStart(table, "input", module.type->hasInputs(), module.inputStart, module.inputPosition);
  readStart(table, "output", module.type->hasOutputs(), module.outputStart, module.outputPosition);
  return module;
}

std::optional<io::Module> readTelegram(const Table& table) {
  const bool known = table.allow({"type", "input", "output", "name"});
  if (!table.has("type")) {
    if (known) table.mustBe("type", "the telegram of the drive: " + telegramNames());
    return std::nullopt;
  }
  const auto type = table.text("type", "the telegram of the drive: " + telegramNames());
  if (!type) return std::nullopt;
  const auto found = std::ranges::find_if(plant::telegrams(), [&](const plant::Telegram* one) {
    return equalsIgnoreCase(one->name, trim(*type));
  });
  if (found == plant::telegrams().end()) {
    table.mustBe("type", "the telegram of the drive: " + telegramNames());
    return std::nullopt;
  }
  io::Module module;
  module.own =
      io::dataModule(std::string((*found)->name), 2u * (*found)->actuals, 2u * (*found)->setpoints);
  module.type = module.own.get();
  module.parameters = io::Parameters::of(*module.type);
  module.position = table.place();
  module.name = table.text("name", "a text").value_or("");
  readStart(table, "input", true, module.inputStart, module.inputPosition);
  readStart(table, "output", true, module.outputStart, module.outputPosition);
  return module;
}

}  // namespace merker::project
