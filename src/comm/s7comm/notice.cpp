#include "s7comm/notice.h"

#include "base/bytes.h"
#include "s7comm/data_item.h"

namespace merker::s7comm {
namespace {

// Userdata of one variable specification of syntax 13h, which is R_ID.
constexpr std::uint8_t kNoticeParameters[] = {0x00, 0x01, 0x12, 0x06, 0x13, 0x00};
constexpr std::size_t kSyntaxAt = 4, kNoticeLength = sizeof kNoticeParameters + 4;

// Return code, a byte that no source explains, number of areas.
constexpr std::size_t kNoticeHead = 4;

}  // namespace

bool isNotice(const Pdu& pdu) {
  const View p = pdu.parameters;
  return pdu.type == PduType::Userdata && p.size() >= kNoticeLength &&
         p[kSyntaxAt] == kNoticeParameters[kSyntaxAt];
}

Bytes writeNotice(std::uint16_t reference, std::uint32_t rid, std::span<const SentArea> areas) {
  Bytes parameters(std::begin(kNoticeParameters), std::end(kNoticeParameters));
  appendDWord(parameters, rid);
  Bytes data = {static_cast<std::uint8_t>(ItemCode::Done), 0};
  appendWord(data, static_cast<std::uint32_t>(areas.size()));
  for (const SentArea& area : areas)
    writeDataItem(data, {ItemCode::Requested, area.unit, area.octets});
  return writePdu({PduType::Userdata, reference, Error::None, parameters, data});
}

std::optional<Notice> readNotice(const Pdu& pdu) {
  View data = pdu.data;
  if (data.size() < kNoticeHead) return std::nullopt;
  const std::size_t count = loadWord(&data[2]);
  data = data.subspan(kNoticeHead);
  Notice notice{.rid = loadDWord(&pdu.parameters[sizeof kNoticeParameters])};
  for (std::size_t i = 0; i < count; ++i) {
    const auto item = readDataItem(data);
    if (!item) return std::nullopt;
    notice.areas.push_back({item->unit, {item->octets.begin(), item->octets.end()}});
  }
  return notice;
}

}  // namespace merker::s7comm
