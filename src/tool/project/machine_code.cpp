#include "project/machine_code.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "base/bytes.h"
#include "block/container.h"
#include "project/files.h"

namespace merker::project {
namespace {

constexpr std::size_t kMegabyte = 1u << 20, kLengthAt = 8, kHeader = 36;

std::vector<std::uint8_t> readBytes(Project& project, const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::vector<std::uint8_t> bytes(source::kLargestSource * kMegabyte + 1);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in.eof() && !in) {
    project.unreadable = true;
    project.problems.add(ProblemCode::P0101, Position{path}, path, std::strerror(errno));
    return {};
  }
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.size() > source::kLargestSource * kMegabyte) {
    project.problems.add(ProblemCode::P0103, Position{path}, source::kLargestSource,
                         "machine code");
    return {};
  }
  if (bytes.empty()) project.problems.add(ProblemCode::P0601, Position{path}, "the file is empty");
  return bytes;
}

}  // namespace

bool isMachineCode(std::string_view path) { return hasExtension(path, ".mc7"); }

void readMachineCode(Project& project, const std::string& path) {
  const std::vector<std::uint8_t> bytes = readBytes(project, path);
  for (std::span<const std::uint8_t> rest(bytes); !rest.empty();) {
    auto block = block::readContainer(rest, Position{path});
    if (!block) return project.problems.add(block.error());
    if (block->id.kind != BlockKind::SDB)
      project.machineCode.push_back({path, std::move(block.value())});
    rest = rest.subspan(std::max<std::size_t>(kHeader, loadDWord(&rest[kLengthAt])));
  }
}

}  // namespace merker::project
