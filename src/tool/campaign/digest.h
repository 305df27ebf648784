// SHA-256 of a text that comes in pieces.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace merker::campaign {

class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  void add(std::string_view piece);
  // With its length, so that two pieces are never one longer piece.
  void addPart(std::string_view part);
  // Ends it.
  std::array<std::uint8_t, 32> bytes();
  std::string text();  // 64 hexadecimal digits

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace merker::campaign
