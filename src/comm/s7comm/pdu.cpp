#include "s7comm/pdu.h"

#include "base/bytes.h"

namespace merker::s7comm {
namespace {

constexpr std::uint8_t kProtocol = 0x32;

bool isAnswer(PduType type) { return type == PduType::Acknowledge || type == PduType::Answer; }

bool isType(std::uint8_t code) { return (code >= 1 && code <= 3) || code == 7; }

}  // namespace

std::optional<Pdu> readPdu(View bytes) {
  if (bytes.size() < kHeader || bytes[0] != kProtocol || !isType(bytes[1])) return std::nullopt;
  Pdu pdu{.type = static_cast<PduType>(bytes[1]), .reference = loadWord(&bytes[4])};
  const std::size_t header = isAnswer(pdu.type) ? kAnswerHeader : kHeader;
  const std::size_t parameters = loadWord(&bytes[6]), data = loadWord(&bytes[8]);
  if (header + parameters + data > bytes.size()) return std::nullopt;
  if (isAnswer(pdu.type)) pdu.error = static_cast<Error>(loadWord(&bytes[10]));
  pdu.parameters = bytes.subspan(header, parameters);
  pdu.data = bytes.subspan(header + parameters, data);
  return pdu;
}

Bytes writePdu(const Pdu& pdu) {
  Bytes out;
  out.reserve(kAnswerHeader + pdu.parameters.size() + pdu.data.size());
  out.insert(out.end(), {kProtocol, static_cast<std::uint8_t>(pdu.type), 0, 0});
  appendWord(out, pdu.reference);
  appendWord(out, static_cast<std::uint32_t>(pdu.parameters.size()));
  appendWord(out, static_cast<std::uint32_t>(pdu.data.size()));
  if (isAnswer(pdu.type)) appendWord(out, static_cast<std::uint32_t>(pdu.error));
  out.insert(out.end(), pdu.parameters.begin(), pdu.parameters.end());
  out.insert(out.end(), pdu.data.begin(), pdu.data.end());
  return out;
}

}  // namespace merker::s7comm
