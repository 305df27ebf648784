#include "s7comm/request.h"

#include "base/bytes.h"
#include "s7comm/data_item.h"

namespace merker::s7comm {
namespace {

constexpr std::uint8_t kSetup = 0xF0, kRead = 0x04, kWrite = 0x05;

bool answers(const Pdu& pdu, std::uint8_t function, std::size_t parameters) {
  return pdu.type == PduType::Answer && pdu.error == Error::None &&
         pdu.parameters.size() == parameters && pdu.parameters[0] == function;
}

Bytes itemParameters(std::uint8_t function, std::span<const AnyItem> items) {
  Bytes parameters = {function, static_cast<std::uint8_t>(items.size())};
  for (const AnyItem& item : items) writeItem(parameters, item);
  return parameters;
}

}  // namespace

Bytes setupRequest(std::uint16_t reference, const Offer& wanted) {
  Bytes parameters = {kSetup, 0};
  appendWord(parameters, wanted.jobs);
  appendWord(parameters, wanted.jobs);
  appendWord(parameters, wanted.pdu);
  return writePdu({.reference = reference, .parameters = parameters});
}

Bytes readRequest(std::uint16_t reference, std::span<const AnyItem> items) {
  return writePdu({.reference = reference, .parameters = itemParameters(kRead, items)});
}

Bytes writeRequest(std::uint16_t reference, std::span<const AnyItem> items,
                   std::span<const Bytes> values) {
  Bytes data;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const ElementRow* const element = findElement(static_cast<std::uint8_t>(items[i].type));
    writeDataItem(data, {ItemCode::Requested, element->answer, values[i]});
  }
  return writePdu(
      {.reference = reference, .parameters = itemParameters(kWrite, items), .data = data});
}

std::optional<Offer> setupAnswer(const Pdu& answer) {
  if (!answers(answer, kSetup, 8)) return std::nullopt;
  return Offer{.pdu = loadWord(&answer.parameters[6]), .jobs = loadWord(&answer.parameters[2])};
}

std::optional<std::vector<Value>> readAnswer(const Pdu& answer) {
  if (!answers(answer, kRead, 2)) return std::nullopt;
  std::vector<Value> values(answer.parameters[1]);
  View data = answer.data;
  for (Value& value : values) {
    const auto item = readDataItem(data);
    if (!item) return std::nullopt;
    value = {item->code, Bytes(item->octets.begin(), item->octets.end())};
  }
  return values;
}

std::optional<std::vector<ItemCode>> writeAnswer(const Pdu& answer) {
  if (!answers(answer, kWrite, 2) || answer.data.size() != answer.parameters[1])
    return std::nullopt;
  std::vector<ItemCode> codes;
  for (const std::uint8_t code : answer.data) codes.push_back(static_cast<ItemCode>(code));
  return codes;
}

}  // namespace merker::s7comm
