#include "pcap.h"

#include <string>

namespace merker::app {
namespace {

constexpr std::uint32_t kNanosecondFile = 0xA1B23C4D, kLongestPacket = 65'535,
                        kRtacSerial = 250;  // LINKTYPE_RTAC_SERIAL
constexpr std::size_t kMostCharacters = 2'048;
constexpr std::uint8_t kSent = 1, kReceived = 2;  // DATA_TX_START, DATA_RX_START
constexpr std::int64_t kSecond = 1'000'000'000;

// The header of the file and of each packet: little endian.
void put(std::ostream& out, std::uint32_t value, int bytes = 4) {
  for (int i = 0; i < bytes; ++i) out.put(static_cast<char>(value >> 8 * i & 0xFF));
}

// The pseudo header of the link type: big endian.
void putNetwork(std::string& text, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 0xFF);
}

void packet(std::ostream& out, const serial::Sighting& first, const std::string& characters) {
  const auto seconds = static_cast<std::uint32_t>(first.start.ns / kSecond);
  const auto rest = static_cast<std::uint32_t>(first.start.ns % kSecond);
  std::string content;
  putNetwork(content, seconds);
  putNetwork(content, rest / 1'000);
  content += static_cast<char>(first.port == 0 ? kSent : kReceived);
  content.append(3, '\0');  // no control lines, footer
  content += characters;
  put(out, seconds);
  put(out, rest);
  for (int i = 0; i < 2; ++i) put(out, static_cast<std::uint32_t>(content.size()));
  out << content;
}

// A BREAK has no characters; without a pause in between.
bool follows(const serial::Sighting& before, const serial::Sighting& one) {
  return one.isCharacter() && one.port == before.port &&
         one.start - before.end < before.end - before.start;
}

}  // namespace

void writePcap(const std::deque<serial::Sighting>& sightings, std::ostream& out) {
  put(out, kNanosecondFile);
  put(out, 2, 2);  // version 2.4
  put(out, 4, 2);
  put(out, 0);  // time zone
  put(out, 0);  // accuracy
  put(out, kLongestPacket);
  put(out, kRtacSerial);
  for (std::size_t i = 0; i < sightings.size();) {
    const std::size_t first = i;
    if (!sightings[i++].isCharacter()) continue;
    std::string characters(1, static_cast<char>(sightings[first].value));
    while (i < sightings.size() && characters.size() < kMostCharacters &&
           follows(sightings[i - 1], sightings[i]))
      characters += static_cast<char>(sightings[i++].value);
    packet(out, sightings[first], characters);
  }
}

}  // namespace merker::app
