#include "input.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

#include "source/source_file.h"

namespace merker::app {
namespace {

Result<std::string> all(std::istream& in, const std::string& name, std::string_view kind) {
  constexpr std::size_t kMegabyte = 1 << 20;
  std::string bytes;
  std::vector<char> buffer(kMegabyte);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
    bytes.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > source::kLargestSource * kMegabyte)
      return makeProblem(ProblemCode::P0103, Position{name}, source::kLargestSource, kind);
  }
  return bytes;
}

}  // namespace

Result<std::string> readBytes(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return makeProblem(ProblemCode::P0101, Position{path}, path, "it is a folder");
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    return makeProblem(ProblemCode::P0101, Position{path}, path, "it is not a regular file");
  std::ifstream in(path, std::ios::binary);
  if (!in) return makeProblem(ProblemCode::P0101, Position{path}, path, std::strerror(errno));
  return all(in, path, "machine code");
}

Result<std::string> readStandardInput() {
  return all(std::cin, "standard input", "standard input");
}

bool writeText(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) std::cerr << "merker: cannot write " << path << ": " << std::strerror(errno) << '\n';
  return static_cast<bool>(out);
}

}  // namespace merker::app
