#include "importing/hardware.h"

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "catalogue/cpu_model.h"
#include "catalogue/module_type.h"

namespace merker::importing {
namespace {

constexpr std::size_t kMostModules = 1000;
constexpr std::uint32_t kCpuSlot = 2;

std::optional<std::uint32_t> numberAt(std::string_view text) {
  text = trim(text);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<std::uint32_t> numberBehind(std::string_view line, std::string_view word) {
  const std::size_t at = line.find(word);
  return at == std::string_view::npos ? std::nullopt : numberAt(line.substr(at + word.size()));
}

std::vector<std::string> quoted(std::string_view line) {
  std::vector<std::string> texts;
  while (true) {
    const std::size_t begin = line.find('"');
    const std::size_t end = begin == std::string_view::npos ? begin : line.find('"', begin + 1);
    if (end == std::string_view::npos) return texts;
    texts.emplace_back(line.substr(begin + 1, end - begin - 1));
    line.remove_prefix(end + 1);
  }
}

class Reader {
 public:
  explicit Reader(Material& material) : material_(material) {}

  void line(std::string_view text) {
    if (text.starts_with("STATION")) {
      if (const auto names = quoted(text); !names.empty()) material_.station = names.back();
    } else if (text.starts_with("RACK")) {
      rack(text);
    } else if (isHeader(text)) {
      current_ = nullptr;  // distributed periphery and subnets
    } else if (text.starts_with("LOCAL_IN_ADDRESSES") || text.starts_with("LOCAL_OUT_ADDRESSES")) {
      output_ = text.starts_with("LOCAL_OUT");
    } else if (text.starts_with("ADDRESS") && current_ != nullptr) {
      auto& start = output_ ? current_->output : current_->input;
      if (!start) start = numberBehind(text, "ADDRESS");
    }
  }

 private:
  static bool isHeader(std::string_view text) {
    for (const std::string_view word : {"DPSUBSYSTEM", "IOSUBSYSTEM", "SUBNET", "MASTER"})
      if (text.starts_with(word)) return true;
    return false;
  }

  // RACK 0, SLOT 4, "6ES7 321-1BH02-0AA0" "V2.0", "DI16xDC24V"
  void rack(std::string_view text) {
    current_ = nullptr;
    const auto slot = numberBehind(text, " SLOT "), number = numberBehind(text, "RACK ");
    const auto names = quoted(text);
    if (!slot || !number || names.empty()) return;
    if (material_.modules.size() >= kMostModules) {
      ++material_.modulesLeftOut;
      return;
    }
    const std::uint32_t subslot = numberBehind(text, "SUBSLOT ").value_or(0);
    if (*slot == kCpuSlot && subslot == 0 && *number == 0) {
      material_.cpu = names.back();
      material_.cpuOrderNumber = names.front();
      return;
    }
    material_.modules.push_back({*number, *slot, subslot, names.front(), names.back(), {}, {}});
    current_ = &material_.modules.back();
  }

  Material& material_;
  HardwareModule* current_ = nullptr;
  bool output_ = false;
};

std::string tomlText(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "\"";
}

std::string moduleText(const HardwareModule& module, bool onBoard) {
  std::string out = "\n[[module]]\n";
  out += onBoard ? fmt::format("slot = \"{}.{}\"\n", module.slot, module.subslot)
                 : fmt::format("slot = {}\ntype = {}\n", module.slot, tomlText(module.orderNumber));
  if (module.rack != 0) out += fmt::format("rack = {}\n", module.rack);
  if (module.input) out += fmt::format("input = {}\n", *module.input);
  if (module.output) out += fmt::format("output = {}\n", *module.output);
  return out;
}

// A module as the catalogue knows it, with only the addresses that it has.
std::string moduleText(HardwareModule module, const CpuModel& model) {
  const bool onBoard = module.slot == kCpuSlot && module.subslot != 0;
  const ModuleType* type = nullptr;
  if (onBoard) type = onBoardType(model, module.subslot);
  if (const auto types = findModuleTypes(module.orderNumber); !onBoard && types.size() == 1)
    type = types.front();
  if (type == nullptr) return {};
  if (!type->hasInputs()) module.input.reset();
  if (!type->hasOutputs()) module.output.reset();
  return moduleText(module, onBoard);
}

std::string withoutBlanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '-') out += c;
  return upper(out);
}

}  // namespace

void readHardware(std::string_view text, Material& material) {
  Reader reader(material);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.line(trim(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::string modelOf(const Material& material, Report& report) {
  const std::string order = withoutBlanks(material.cpuOrderNumber);
  for (const CpuModel& model : cpuModels())
    if (!order.empty() && withoutBlanks(model.orderNumber) == order)
      return std::string(model.keyword);
  if (const CpuModel* model = findCpuModel(material.cpu); model != nullptr && !material.cpu.empty())
    return std::string(model->keyword);
  // The S7-400 has four accumulators.
  const bool large = withoutBlanks(material.cpu).starts_with("CPU4") || order.starts_with("6ES74");
  const std::string model = large ? "generic-4" : "generic";
  if (material.cpu.empty())
    report.add(Note::NoStation, model);
  else
    report.add(Note::GenericCpu, material.cpu, model);
  return model;
}

std::string settingsText(const Material& material, const std::string& model, Report& report) {
  std::string out = fmt::format("[project]\nname = {}\n\n[cpu]\nmodel = {}\n",
                                tomlText(material.name), tomlText(model));
  const CpuModel* cpu = findCpuModel(model);
  std::size_t written = 0;
  for (const HardwareModule& module : material.modules) {
    if (module.slot == kCpuSlot && module.subslot == 0) continue;
    const std::string text = moduleText(module, *cpu);
    written += text.empty() ? 0 : 1;
    out += text;
    if (text.empty() && (module.slot != kCpuSlot || module.input || module.output))
      report.add(Note::UnknownModule, module.rack, module.slot, module.orderNumber, module.name);
  }
  if (written > 0) report.add(Note::Modules, written);
  return out;
}

}  // namespace merker::importing
