#include "input.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace merker::app {
namespace {

std::string all(std::istream& in) {
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

Result<std::string> readBytes(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return makeProblem(ProblemCode::P0101, Position{path}, path, "it is a folder");
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    return makeProblem(ProblemCode::P0101, Position{path}, path, "it is no regular file");
  std::ifstream in(path, std::ios::binary);
  if (!in) return makeProblem(ProblemCode::P0101, Position{path}, path, std::strerror(errno));
  return all(in);
}

std::string readStandardInput() { return all(std::cin); }

bool writeText(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) std::cerr << "merker: cannot write " << path << ": " << std::strerror(errno) << '\n';
  return static_cast<bool>(out);
}

}  // namespace merker::app
