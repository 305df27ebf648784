#include "workbench/network_file.h"

#include "compilation/network.h"
#include "workbench/fresh_errors.h"

namespace merker::workbench {

std::string tomlText(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) out += c;
  }
  return out + "\"";
}

std::optional<Problem> firstError(const Problems& problems) {
  for (const Problem& one : problems.list())
    if (one.severity() == Severity::Error) return one;
  return std::nullopt;
}

NetworkFile::NetworkFile(const std::string& path)
    : folder_(project::load(path, {}).folder), read_(folder_.read(kNetworkFile)) {}

std::optional<Problem> NetworkFile::problem() const {
  if (!read_) return read_.error();
  return std::nullopt;
}

project::SettingsEdit NetworkFile::edit() const {
  return {folder_.full(kNetworkFile), read_->text};
}

project::Project NetworkFile::with(const std::string& text) const {
  return project::load(folder_.folder(), {}, {{folder_.full(kNetworkFile), text}});
}

std::optional<Problem> NetworkFile::freshError(const std::string& text) const {
  const auto before = compilation::buildNetwork(with(read_->text), false);
  const auto after = compilation::buildNetwork(with(text), false);
  return firstError(freshErrors(before.problems, after.problems));
}

std::optional<Problem> NetworkFile::write(const std::string& text) const {
  return folder_.write(kNetworkFile, text, read_->revision);
}

}  // namespace merker::workbench
