// Inputs of fuzz_s7comm are PDUs, each behind an octet with its length. A change of single octets
// breaks those lengths nearly always, and few PDUs are left of an input; so PDUs are changed one by
// one, and some are repeated, left out or moved to another place.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

// Of libFuzzer: changes octets in their place and answers their new number, at most `most`.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using Pdu = std::vector<std::uint8_t>;
constexpr std::size_t kLongest = 255, kMost = 64;

std::vector<Pdu> split(const std::uint8_t* data, std::size_t size) {
  std::vector<Pdu> pdus;
  for (std::size_t at = 0; at < size && pdus.size() < kMost;) {
    const std::size_t length = std::min<std::size_t>(data[at], size - at - 1);
    pdus.emplace_back(data + at + 1, data + at + 1 + length);
    at += 1 + length;
  }
  return pdus;
}

void change(Pdu& pdu) {
  const std::size_t size = pdu.size();
  pdu.resize(kLongest);
  pdu.resize(LLVMFuzzerMutate(pdu.data(), size, kLongest));
}

// An input becomes twice as long as often as it becomes shorter.
void move(std::vector<Pdu>& pdus, std::minstd_rand& random) {
  const auto any = [&] { return random() % pdus.size(); };
  const std::size_t more = random() % 4 == 0 ? pdus.size() : 1;
  if (random() % 2 == 0)
    for (std::size_t i = 0; i < more && pdus.size() < kMost; ++i) {
      Pdu again = pdus[any()];
      pdus.insert(pdus.begin() + static_cast<std::ptrdiff_t>(any()), std::move(again));
    }
  else if (pdus.size() > 1)
    pdus.erase(pdus.begin() + static_cast<std::ptrdiff_t>(any()));
}

std::size_t join(const std::vector<Pdu>& pdus, std::uint8_t* data, std::size_t most) {
  std::size_t at = 0;
  for (const Pdu& pdu : pdus) {
    if (at + 1 + pdu.size() > most) break;
    data[at++] = static_cast<std::uint8_t>(pdu.size());
    if (!pdu.empty()) std::memcpy(data + at, pdu.data(), pdu.size());
    at += pdu.size();
  }
  return at;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  std::minstd_rand random(seed);
  std::vector<Pdu> pdus = split(data, size);
  if (pdus.empty()) pdus.emplace_back(1);
  if (random() % 2 == 0) move(pdus, random);
  for (Pdu& pdu : pdus)
    if (random() % 3 == 0) change(pdu);
  return join(pdus, data, most);
}
