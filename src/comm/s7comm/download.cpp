// 1Ah to 1Ch: a block for the PLC. The client announces it; then it is the PLC that asks for piece
// after piece and tells at the end whether it can use the block. Afterwards the block is passive.
#include <optional>

#include "base/bytes.h"
#include "s7comm/block_name.h"
#include "s7comm/services.h"

namespace merker::s7comm {
namespace {

constexpr std::uint8_t kPiece = 0x1B, kEnded = 0x1C;
constexpr std::size_t kDigits = 6;

struct Announced {
  BlockName name;
  std::size_t octets = 0, code = 0;  // in load memory; of these what runs
};

std::optional<std::size_t> numberIn(View digits) {
  std::size_t number = 0;
  for (const std::uint8_t digit : digits) {
    if (digit < '0' || digit > '9') return std::nullopt;
    number = number * 10 + digit - '0';
  }
  return number;
}

// Function, 7 octets, length of the name, "_", name; length of the lengths, "1", those of the
// block in load memory and of its code, 6 digits each.
std::optional<Announced> announced(View p) {
  constexpr std::size_t kName = 10, kNameLength = 8, kLengths = kName + kNameLength;
  constexpr std::size_t kAll = kLengths + 2 + 2 * kDigits;
  if (p.size() != kAll || p[8] != kNameLength + 1 || p[9] != '_' || p[kLengths] != 1 + 2 * kDigits)
    return std::nullopt;
  const auto name = blockNameOf(p.subspan(kName, kNameLength));
  const auto octets = numberIn(p.subspan(kLengths + 2, kDigits));
  const auto code = numberIn(p.last(kDigits));
  if (!name || !octets || !code) return std::nullopt;
  return Announced{*name, *octets, *code};
}

// Function, status, error, 4 octets, length of the name, "_", name.
void askFor(const Job& job, std::uint8_t function, Error error, Session::Heard heard) {
  Bytes parameters = {function, 0};
  appendWord(parameters, static_cast<std::uint32_t>(error));
  const std::string name = '_' + textOf(*job.download().name);
  parameters.insert(parameters.end(), {0, 0, 0, 0, static_cast<std::uint8_t>(name.size())});
  parameters.insert(parameters.end(), name.begin(), name.end());
  job.ask(parameters, heard);
}

void endHeard(const Job& job, const Pdu&) { job.download() = {}; }

void end(const Job& job, Error error) { askFor(job, kEnded, error, endHeard); }

// Length, 00 FB, octets. Nothing: it is no piece.
std::optional<View> pieceIn(const Pdu& answer) {
  constexpr std::size_t kHead = 4;
  const View p = answer.parameters, data = answer.data;
  const bool good = p.size() == 2 && p[0] == kPiece && data.size() > kHead;
  if (!good || loadWord(data.data()) != data.size() - kHead) return std::nullopt;
  return data.subspan(kHead);
}

void keep(const Job& job) {
  Session::Download& download = job.download();
  if (download.octets.size() != download.announced) return end(job, Error::WrongBlockLength);
  job.plc().keep(*download.name, std::move(download.octets), job.password(),
                 [begun = job.begun()](Error error) {
                   end(begun, error);
                   begun.ended();
                 });
}

void pieceHeard(const Job& job, const Pdu& answer) {
  Session::Download& download = job.download();
  if (!download.name) return;  // of one that has ended
  if (answer.type != PduType::Answer || answer.error != Error::None) {
    download = {};  // the client gives up
    return;
  }
  const auto piece = pieceIn(answer);
  if (!piece || piece->size() > download.announced - download.octets.size())
    return end(job, Error::TransferFailed);
  download.octets.insert(download.octets.end(), piece->begin(), piece->end());
  const bool more = (answer.parameters[1] & 1) != 0;
  more ? askFor(job, kPiece, Error::None, pieceHeard) : keep(job);
}

}  // namespace

// One at a time: a new one ends the one before.
void serveRequestDownload(const Job& job) {
  const auto wish = announced(job.parameters);
  if (!wish) return job.refuse(Error::WrongBlockName);
  if (wish->code == 0 || wish->code > wish->octets) return job.refuse(Error::WrongBlockLength);
  if (wish->name.files != FileSystem::Passive) return job.refuse(Error::WrongBlockFiles);
  job.download() = {};
  job.plc().admit(wish->name, wish->octets, job.password(),
                  [begun = job.begun(), wish](Error error) {
                    if (error == Error::None) {
                      begun.download() = {wish->name, wish->octets, {}};
                      begun.answer(View(&begun.function, 1));
                      askFor(begun, kPiece, Error::None, pieceHeard);
                    } else {
                      begun.refuse(error);
                    }
                    begun.ended();
                  });
}

}  // namespace merker::s7comm
