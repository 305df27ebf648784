// 1Dh to 1Fh: a block as it lies in the CPU, in pieces.
#include <algorithm>
#include <string>
#include <utility>

#include "base/bytes.h"
#include "s7comm/block_name.h"
#include "s7comm/services.h"

namespace merker::s7comm {
namespace {

// Clients take pieces of a PDU of 240 octets, whatever was agreed on.
constexpr std::size_t kPiecePdu = 240, kPieceHead = 4;
constexpr std::uint8_t kPieceMark = 0xFB;
constexpr std::size_t kUploadParameters = 8, kNameBegins = 10;

// What stands in front of a name, as Wireshark's dissector has it: all of the block, or its head up
// to the code.
constexpr std::uint8_t kWholeBlock = '_', kHeadOnly = '$';
constexpr std::size_t kBlockHead = 36;

// Behind the function stands the number of the upload. A connection has one alone: it is not
// looked at, since recorded conversations have the number that another PLC gave.
bool isOpen(const Job& job) {
  return job.parameters.size() == kUploadParameters && !job.upload().octets.empty();
}

// Function, status, 2 octets, number, length of the length, 7 digits.
Bytes startAnswer(const Job& job, const Session::Upload& upload) {
  Bytes answer = {job.function, 0, 1, 0};
  appendDWord(answer, upload.number);
  const std::string digits = std::to_string(10'000'000 + upload.octets.size());
  answer.push_back(7);
  answer.insert(answer.end(), digits.begin() + 1, digits.end());
  return answer;
}

void beginUpload(const Job& job, Error error, Bytes octets) {
  Session::Upload& upload = job.upload();
  upload = {upload.number % 0xFF + 1, std::move(octets), 0};
  error == Error::None ? job.answer(startAnswer(job, upload)) : job.refuse(error);
}

}  // namespace

// One at a time: a new one ends the one before.
void serveStartUpload(const Job& job) {
  const View p = job.parameters;
  constexpr std::size_t kLength = 8;  // of the name and what stands in front of it
  const bool named = p.size() > kNameBegins && p[kLength] == p.size() - kLength - 1 &&
                     (p[9] == kWholeBlock || p[9] == kHeadOnly);
  const auto name = named ? blockNameOf(p.subspan(kNameBegins)) : std::nullopt;
  if (!name) return job.refuse(Error::WrongBlockName);
  const bool head = p[9] == kHeadOnly;
  const auto done = [begun = job.begun(), head](Error error, const Bytes& container) {
    Bytes octets = error == Error::None ? container : Bytes();
    if (head) octets.resize(std::min(octets.size(), kBlockHead));
    beginUpload(begun, error, std::move(octets));
    begun.ended();
  };
  head ? job.plc().blockHead(*name, done) : job.plc().block(*name, job.password(), done);
}

// Behind the last piece there is an empty one.
void serveUpload(const Job& job) {
  Session::Upload& upload = job.upload();
  if (!isOpen(job)) return job.refuse(Error::CannotBeDone);
  const std::size_t pdu = std::min<std::size_t>(job.pdu(), kPiecePdu);
  const std::size_t most = pdu - kAnswerHeader - 2 - kPieceHead;
  const std::size_t count = std::min(most, upload.octets.size() - upload.sent);
  const bool more = upload.sent + count < upload.octets.size();
  Bytes piece;
  appendWord(piece, static_cast<std::uint32_t>(count));
  piece.insert(piece.end(), {0, kPieceMark});
  const auto begin = upload.octets.begin() + static_cast<std::ptrdiff_t>(upload.sent);
  piece.insert(piece.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
  upload.sent += count;
  const std::uint8_t parameters[] = {job.function, static_cast<std::uint8_t>(more ? 1 : 0)};
  job.answer(parameters, piece);
}

void serveEndUpload(const Job& job) {
  if (!isOpen(job)) return job.refuse(Error::CannotBeDone);
  job.upload().octets.clear();
  const std::uint8_t parameters[] = {job.function};
  job.answer(parameters);
}

}  // namespace merker::s7comm
