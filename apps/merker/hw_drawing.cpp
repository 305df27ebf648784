#include "hw_drawing.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "io/asi.h"
#include "io/slave.h"
#include "profibus/bus_cycle.h"

namespace merker::app {
namespace {

using Lines = std::vector<std::string>;

// One slot as it is drawn: its lines, the first of which is its number.
struct Box {
  Lines lines;
  std::size_t width() const {
    std::size_t width = 0;
    for (const std::string& line : lines) width = std::max(width, characterCount(line));
    return width;
  }
};

// A terminal's width; a longer rack goes on below.
constexpr std::size_t kWidth = 110;

std::string addresses(std::string_view letter, bool digital, bool words, std::uint32_t first,
                      std::uint32_t last) {
  if (digital) return fmt::format("{} {}.0..{}.7", letter, first, last);
  if (words) return fmt::format("P{}W {}..{}", letter, first, last - 1);
  return fmt::format("P{} {}..{}", letter, first, last);
}

Lines describe(const io::Module& module, std::string_view indent) {
  Lines lines;
  const auto add = [&](const std::string& line) {
    if (!line.empty()) lines.push_back(fmt::format("{}{}", indent, line));
  };
  add(inputText(module));
  add(outputText(module));
  if (module.type->placeholder()) add("(addresses only)");
  if (!module.name.empty()) add(fmt::format("\"{}\"", module.name));
  return lines;
}

Box boxOf(const io::Module& module) {
  Box box{{fmt::format("{}", module.slot), std::string(module.type->name),
           std::string(module.type->text)}};
  for (std::string& line : describe(module, "")) box.lines.push_back(std::move(line));
  return box;
}

// The CPU with its sub-modules.
Box cpuBox(const io::Configuration& configuration) {
  Box box{{"2", std::string(configuration.model->name)}};
  for (const io::Module& module : configuration.modules) {
    if (!module.onBoard()) continue;
    box.lines.push_back(fmt::format("{} {}", module.slotText(), title(*module.type)));
    for (std::string& line : describe(module, "    ")) box.lines.push_back(std::move(line));
  }
  return box;
}

std::vector<Box> boxes(const io::Configuration& configuration, std::uint32_t rack) {
  std::vector<Box> list;
  bool cpu = rack != 0;
  for (const io::Module& module : configuration.modules) {
    if (module.rack != rack) continue;
    if (!cpu && module.slot >= 2) {
      list.push_back(cpuBox(configuration));
      cpu = true;
    }
    if (!module.onBoard()) list.push_back(boxOf(module));
  }
  if (!cpu) list.push_back(cpuBox(configuration));
  return list;
}

// ┌──┬──┐ with these three corners
std::string rule(const std::vector<Box>& row, std::string_view left, std::string_view middle,
                 std::string_view right) {
  std::string line;
  for (const Box& box : row) {
    line += line.empty() ? left : middle;
    for (std::size_t i = 0; i < box.width() + 2; ++i) line += "─";
  }
  return line + std::string(right) + "\n";
}

std::string draw(const std::vector<Box>& row) {
  std::size_t height = 0;
  for (const Box& box : row) height = std::max(height, box.lines.size());
  std::string text = rule(row, "┌", "┬", "┐");
  for (std::size_t i = 0; i < height; ++i) {
    for (const Box& box : row) {
      const std::string line = i < box.lines.size() ? box.lines[i] : std::string();
      text += fmt::format("│ {}{} ", line, std::string(box.width() - characterCount(line), ' '));
    }
    text += "│\n";
  }
  return text + rule(row, "└", "┴", "┘");
}

// Boxes side by side, as many as fit into a line.
std::string drawAll(const std::vector<Box>& all) {
  std::string text;
  std::vector<Box> row;
  std::size_t width = 1;
  for (const Box& box : all) {
    if (!row.empty() && width + box.width() + 3 > kWidth) {
      text += draw(row);
      row.clear();
      width = 1;
    }
    width += box.width() + 3;
    row.push_back(box);
  }
  return row.empty() ? text : text + draw(row);
}

std::string cable(const io::Configuration& configuration, std::uint32_t rack) {
  for (const io::Module& module : configuration.modules)
    if (module.rack == rack && module.cable) return fmt::format(", cable {:g} m", *module.cable);
  return {};
}

// "AS-Interface of slot 4", then a line for each slave.
std::string asiText(const io::Configuration& configuration) {
  std::string text;
  std::optional<std::uint32_t> cp;
  for (const io::Module& module : configuration.modules) {
    if (!module.asiCp) continue;
    const io::Module& master = configuration.modules[*module.asiCp];
    if (std::exchange(cp, module.asiCp) != module.asiCp)
      text += fmt::format("AS-Interface of slot {}, E and A {} to {}\n", master.slotText(),
                          *master.inputStart, master.inputEnd());
    const std::uint32_t shift = io::asiShift(module.slot);
    text += fmt::format("  {:>3} {:<16} {}  byte {}, bits {} to {}\n", module.slot, module.name,
                        module.title(), *master.inputStart + io::asiByte(module.slot), shift,
                        shift + io::kAsiBits - 1);
  }
  return text.empty() ? text : text + '\n';
}

std::string moduleLines(const std::vector<io::Module>& modules) {
  std::string text;
  for (const io::Module& module : modules)
    text += fmt::format("      {:<8} {:<32} {}{}{}\n", module.slotText(), module.title(),
                        inputText(module), module.inputStart && module.outputStart ? ", " : "",
                        outputText(module));
  return text;
}

// Of a station that is a slave itself.
std::string ownSlaveText(const io::Configuration& configuration) {
  if (!configuration.ownSlave) return {};
  const io::Slave& self = configuration.ownSlave->self;
  return fmt::format("PROFIBUS-DP: slave {} of master {}, diagnostic address {}\n{}\n",
                     self.address, configuration.ownSlave->master, self.diagnosis,
                     moduleLines(self.modules));
}

// "DP master 2, bus cycle 1.234 ms", then a line for each slave and each module of it.
std::string slavesText(const io::Configuration& configuration) {
  if (!configuration.dp) return {};
  const io::DpMaster& master = *configuration.dp;
  std::string text = fmt::format("PROFIBUS-DP: master {}, {} kbit/s, bus cycle {:.3f} ms\n",
                                 master.address, static_cast<double>(master.rate) / 1e3,
                                 static_cast<double>(profibus::busCycle(master).length.ns) / 1e6);
  for (const io::Slave& slave : master.slaves) {
    text += fmt::format("  {:>3} {} ({}), diagnostic address {}\n", slave.address, slave.name,
                        slave.model, slave.diagnosis);
    text += moduleLines(slave.modules);
  }
  return text + '\n';
}

}  // namespace

std::string inputText(const io::Module& module) {
  if (!module.inputStart) return {};
  return addresses("E", module.type->digitalInputs > 0, module.type->analogInputs > 0,
                   *module.inputStart, module.inputEnd());
}

std::string outputText(const io::Module& module) {
  if (!module.outputStart) return {};
  return addresses("A", module.type->digitalOutputs > 0, module.type->analogOutputs > 0,
                   *module.outputStart, module.outputEnd());
}

std::string drawRacks(const io::Configuration& configuration) {
  std::uint32_t last = 0;
  for (const io::Module& module : configuration.modules)
    if (module.rack < io::kAsiRack) last = std::max(last, module.rack);
  std::string text;
  for (std::uint32_t rack = 0; rack <= last; ++rack) {
    const std::vector<Box> row = boxes(configuration, rack);
    if (row.empty()) continue;
    const io::Current current = io::current(configuration, rack);
    text += fmt::format("Rack {}{}\n{}backplane bus: {} of {} mA\n\n", rack,
                        cable(configuration, rack), drawAll(row), current.taken, current.possible);
  }
  return text + asiText(configuration) + slavesText(configuration) + ownSlaveText(configuration);
}

}  // namespace merker::app
