#include "workbench/serial_view.h"

#include <fmt/format.h>

#include <algorithm>

namespace merker::workbench {

void SerialView::look(const serial::Coupling& coupling) {
  const auto& all = coupling.sightings();
  const std::uint64_t oldest = coupling.seen() - std::min(all.size(), kMostRows);
  if (!decoder_ || oldest > next_) {
    const serial::Parameters& p = coupling.parameters();
    decoder_.emplace(p.protocol, p.procedure.blockCheck);
    rows_.clear();
    next_ = oldest;
  }
  const auto fresh = static_cast<std::ptrdiff_t>(coupling.seen() - next_);
  for (auto one = all.end() - fresh; one != all.end(); ++one)
    rows_.push_back({*one, decoder_->meaning(*one)});
  while (rows_.size() > kMostRows) rows_.pop_front();
  next_ = coupling.seen();
}

Json SerialView::rows(std::uint64_t& from) const {
  from = std::max(from, next_ - rows_.size());
  const auto first = rows_.begin() + static_cast<std::ptrdiff_t>(rows_.size() - (next_ - from));
  const auto count = std::min<std::ptrdiff_t>(rows_.end() - first, kMostTold);
  Json list = Json::array();
  std::for_each(first, first + count, [&list](const Row& row) {
    const serial::Sighting& s = row.sighting;
    list.push_back({s.port, s.value, serial::nameOf(s), row.meaning, s.start.ns, s.end.ns});
  });
  from += static_cast<std::uint64_t>(count);
  return list;
}

namespace {

std::string frameText(const serial::Frame& frame) {
  return fmt::format("{}{}{}", frame.dataBits, "NOE"[static_cast<std::size_t>(frame.parity)],
                     frame.stopBits);
}

const char* protocolText(serial::Protocol protocol, bool blockCheck) {
  constexpr const char* kNames[] = {"ASCII", "3964R", "RK512"};
  if (protocol == serial::Protocol::Procedure && !blockCheck) return "3964";
  return kNames[static_cast<std::size_t>(protocol)];
}

}  // namespace

Json serialLine(serial::Coupling& coupling, const SerialOutside& outside) {
  constexpr const char* kSpeaks[] = {"characters", "3964", "RK512"};
  constexpr const char* kModes[] = {"RS422", "RS422 master", "RS422", "RS485"};
  const serial::Parameters& p = coupling.parameters();
  const serial::Settings& partner = coupling.partnerSettings();
  return {{"protocol", protocolText(p.protocol, p.procedure.blockCheck)},
          {"mode", kModes[static_cast<std::size_t>(p.line.mode)]},
          {"baud", p.line.baud},
          {"frame", frameText(p.line.frame)},
          {"powered", coupling.powered()},
          {"partner", kSpeaks[static_cast<std::size_t>(coupling.partner().speaks())]},
          {"partnerBaud", partner.baud},
          {"partnerFrame", frameText(partner.frame)},
          {"waiting", serial::Partner::kMost - coupling.partner().room()},
          {"connection", outside.connection},
          {"place", outside.place},
          {"connected", outside.connected},
          {"problem", outside.problem},
          {"seen", coupling.seen()}};
}

}  // namespace merker::workbench
