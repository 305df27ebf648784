#include "cpu_option.h"

#include <CLI/CLI.hpp>

#include "project/settings.h"

namespace merker::app {
namespace {

std::string check(const std::string& name) {
  if (project::findModel(name)) return {};
  return "there is no CPU model '" + name + "'; the models are: " + project::modelNames();
}

}  // namespace

void addCpu(CLI::App& command, std::string& cpu) {
  command.add_option("--cpu", cpu, "CPU model instead of the project's")->check(check);
}

}  // namespace merker::app
