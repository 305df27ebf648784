#include "blocks.h"

#include <algorithm>
#include <string>

#include "base/bytes.h"
#include "merker_s7.h"

namespace merker::s7client {
namespace {

using s7comm::Bytes;
using s7comm::Error;
using s7comm::Pdu;

constexpr std::uint8_t kRequestDownload = 0x1A, kDownload = 0x1B, kDownloadEnded = 0x1C;
constexpr std::uint8_t kStartUpload = 0x1D, kUpload = 0x1E, kEndUpload = 0x1F;
constexpr std::uint8_t kService = 0x28, kStop = 0x29;
constexpr std::string_view kProgram = "P_PROGRAM";
// What CPUs say behind the function when they are in that state already.
constexpr std::uint8_t kAlreadyRuns = 0x03, kAlreadyStopped = 0x07;

void append(Bytes& bytes, std::string_view text) {
  bytes.insert(bytes.end(), text.begin(), text.end());
}

std::string digits(std::size_t number, int count) {
  std::string text = std::to_string(number);
  return std::string(static_cast<std::size_t>(count) - std::min<std::size_t>(text.size(), count),
                     '0') +
         text;
}

// Head of a function: octets up to `length`, then a text with its length.
Bytes parametersOf(std::uint8_t function, std::size_t length, std::string_view text = {}) {
  Bytes parameters(length);
  parameters[0] = function;
  if (text.empty()) return parameters;
  parameters.push_back(static_cast<std::uint8_t>(text.size()));
  append(parameters, text);
  return parameters;
}

// `refused`: what any error but a missing password means.
int ask(Connection& connection, const Bytes& parameters, int refused, Pdu& answer) {
  const std::uint16_t reference = connection.nextReference();
  const Bytes request = s7comm::writePdu({.reference = reference, .parameters = parameters});
  if (const int error = connection.exchange(request, reference, answer)) return error;
  if (answer.error == Error::NeedsPassword) return errCliNeedPassword;
  const bool good = answer.type == s7comm::PduType::Answer && answer.error == Error::None &&
                    !answer.parameters.empty() && answer.parameters[0] == parameters[0];
  return good ? 0 : refused;
}

// Length, 00 FB, octets. Empty: it is no piece.
s7comm::View pieceIn(const Pdu& pdu) {
  constexpr std::size_t kHead = 4;
  const bool good = pdu.parameters.size() == 2 && pdu.data.size() > kHead &&
                    loadWord(pdu.data.data()) == pdu.data.size() - kHead;
  return good ? pdu.data.subspan(kHead) : s7comm::View{};
}

int answerPiece(Connection& connection, std::uint16_t reference, s7comm::View rest) {
  constexpr std::size_t kOverhead = s7comm::kAnswerHeader + 2 + 4;
  const std::size_t count = std::min<std::size_t>(rest.size(), connection.pdu() - kOverhead);
  const std::uint8_t parameters[] = {kDownload, static_cast<std::uint8_t>(count < rest.size())};
  Bytes data;
  appendWord(data, static_cast<std::uint32_t>(count));
  appendWord(data, 0x00FB);
  data.insert(data.end(), rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(count));
  return connection.reply(s7comm::writePdu({.type = s7comm::PduType::Answer,
                                            .reference = reference,
                                            .parameters = parameters,
                                            .data = data}));
}

// The CPU asks for piece after piece, then tells how it ended.
int handOver(Connection& connection, const Bytes& container) {
  constexpr std::size_t kErrorAt = 2;
  const std::size_t most = connection.pdu() - s7comm::kAnswerHeader - 6;
  for (std::size_t sent = 0;;) {
    Pdu asked;
    if (const int error = connection.heard(asked)) return error;
    if (asked.parameters.size() <= kErrorAt + 1) return errCliDownloadSequenceFailed;
    if (asked.parameters[0] == kDownload && sent < container.size()) {
      const auto rest = s7comm::View(container).subspan(sent);
      if (const int error = answerPiece(connection, asked.reference, rest)) return error;
      sent += std::min(most, rest.size());
      continue;
    }
    const bool good = asked.parameters[0] == kDownloadEnded &&
                      loadWord(&asked.parameters[kErrorAt]) == 0 && sent == container.size();
    const int error = connection.reply(s7comm::writePdu({.type = s7comm::PduType::Answer,
                                                         .reference = asked.reference,
                                                         .parameters = {&kDownloadEnded, 1}}));
    return error != 0 ? error : good ? 0 : static_cast<int>(errCliDownloadSequenceFailed);
  }
}

int blockService(Connection& connection, std::string_view name, const BlockNumber& block,
                 char files, int refused) {
  return callService(connection, name, std::string("\1\0", 2) + blockName(block, files), refused);
}

}  // namespace

std::string blockName(const BlockNumber& block, char files) {
  return std::string{'0', static_cast<char>(block.type)} +
         digits(static_cast<std::size_t>(block.number), 5) + files;
}

bool isBlock(const BlockNumber& block) {
  constexpr std::string_view kTypes = "8ABCDEF";
  return kTypes.find(static_cast<char>(block.type)) != std::string_view::npos &&
         block.number >= 0 && block.number <= 0xFFFF;
}

int upload(Connection& connection, const BlockNumber& block, Bytes& container) {
  if (!isBlock(block)) return errCliInvalidBlockNumber;
  constexpr std::size_t kNumberAt = 4;
  Pdu answer;
  const Bytes start = parametersOf(kStartUpload, 8, '_' + blockName(block, 'A'));
  if (const int error = ask(connection, start, errCliUploadSequenceFailed, answer)) return error;
  if (answer.parameters.size() < 2 * kNumberAt) return errCliUploadSequenceFailed;
  Bytes next = parametersOf(kUpload, 8);
  std::copy_n(&answer.parameters[kNumberAt], 4, &next[kNumberAt]);
  constexpr std::size_t kLongest = 1 << 20;
  for (bool more = true; more;) {
    if (const int error = ask(connection, next, errCliUploadSequenceFailed, answer)) return error;
    const auto piece = pieceIn(answer);
    if (piece.empty() || container.size() > kLongest) return errCliUploadSequenceFailed;
    container.insert(container.end(), piece.begin(), piece.end());
    more = answer.parameters[1] != 0;
  }
  next[0] = kEndUpload;
  return ask(connection, next, errCliUploadSequenceFailed, answer);
}

int download(Connection& connection, int number, Bytes container) {
  constexpr std::size_t kKindAt = 5, kNumberAt = 6, kCodeLengthAt = 34, kLeast = 72;
  if (container.size() < kLeast) return errCliInvalidBlockSize;
  if (number >= 0) storeWord(&container[kNumberAt], static_cast<std::uint32_t>(number));
  const int kind = container[kKindAt];
  const BlockNumber block{kind == 8 ? '8' : 'A' + kind - 0x0A, loadWord(&container[kNumberAt])};
  if (number > 0xFFFF || !isBlock(block)) return errCliInvalidBlockNumber;
  Bytes request = parametersOf(kRequestDownload, 8, '_' + blockName(block, 'P'));
  const std::string lengths =
      '1' + digits(container.size(), 6) + digits(loadWord(&container[kCodeLengthAt]), 6);
  request.push_back(static_cast<std::uint8_t>(lengths.size()));
  append(request, lengths);
  Pdu answer;
  if (const int error = ask(connection, request, errCliDownloadSequenceFailed, answer))
    return error;
  if (const int error = handOver(connection, container)) return error;
  return blockService(connection, "_INSE", block, 'P', errCliInsertRefused);
}

int removeBlock(Connection& connection, const BlockNumber& block) {
  if (!isBlock(block)) return errCliInvalidBlockNumber;
  return blockService(connection, "_DELE", block, 'B', errCliDeleteRefused);
}

int callService(Connection& connection, std::string_view name, std::string_view argument,
                int refused) {
  Bytes parameters(7);
  parameters[0] = kService;
  parameters.push_back(0xFD);
  appendWord(parameters, static_cast<std::uint32_t>(argument.size()));
  append(parameters, argument);
  parameters.push_back(static_cast<std::uint8_t>(name.size()));
  append(parameters, name);
  Pdu answer;
  const int error = ask(connection, parameters, refused, answer);
  const bool runs = error == errCliCannotStartPLC && answer.parameters.size() > 1 &&
                    answer.parameters[1] == kAlreadyRuns;
  return runs ? static_cast<int>(errCliAlreadyRun) : error;
}

int stopPlc(Connection& connection) {
  Pdu answer;
  const int error = ask(connection, parametersOf(kStop, 6, kProgram), errCliCannotStopPLC, answer);
  const bool stands = error == errCliCannotStopPLC && answer.parameters.size() > 1 &&
                      answer.parameters[1] == kAlreadyStopped;
  return stands ? static_cast<int>(errCliAlreadyStop) : error;
}

}  // namespace merker::s7client
