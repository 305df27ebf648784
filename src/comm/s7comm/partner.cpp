#include "s7comm/partner.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "s7comm/notice.h"
#include "s7comm/request.h"

namespace merker::s7comm {
namespace {

using Kind = PartnerJob::Kind;

// Apart from those of the session beside it, which begin at 1.
constexpr std::uint16_t kFirstReference = 0x8000;

constexpr std::pair<Error, PartnerStatus> kStatuses[] = {
    {Error::None, PartnerStatus::Done},
    {Error::NoSuchObject, PartnerStatus::UnknownReceiver},
    {Error::BlockDisabled, PartnerStatus::Disabled},
    {Error::WrongObjectState, PartnerStatus::NotReady},
    {Error::AccessRefused, PartnerStatus::NoAccess},
};

PartnerStatus statusOf(Error error) {
  const auto* const found =
      std::ranges::find(kStatuses, error, [](auto& row) { return row.first; });
  return found == std::end(kStatuses) ? PartnerStatus::Refused : found->second;
}

// A request that does not fit the PDU is never sent.
Bytes requestOf(const PartnerJob& job, std::uint16_t reference) {
  if (job.kind == Kind::Get) return readRequest(reference, job.items);
  return writeRequest(reference, job.items, job.values);
}

}  // namespace

void Partner::setUp(const Offer& wanted) {
  reference_ = kFirstReference;
  setupAsked_ = true;
  wanted_ = wanted.pdu;
  send_(setupRequest(reference_, wanted));
}

void Partner::agreed(std::uint16_t pdu) {
  pdu_ = pdu;
  program_.connected(true);
  next();
}

void Partner::detach() {
  send_ = nullptr;
  setupAsked_ = false;
  receivers_.interrupt();
  if (std::exchange(pdu_, std::uint16_t{0}) != 0) program_.connected(false);
  while (!jobs_.empty()) finish(PartnerStatus::NoConnection);
}

void Partner::finish(PartnerStatus status, std::vector<Bytes> values) {
  if (!told_) program_.finished({job().number, status, std::move(values)});
  jobs_.pop_front();
  busy_ = dropped_ = told_ = false;
}

void Partner::order(ToPartner orders) {
  if (orders.restart) restart();
  for (const Receiver& one : orders.receivers) set(one);
  for (PartnerJob& one : orders.jobs) jobs_.push_back(std::move(one));
  for (const std::uint32_t number : orders.aborted) abort(number);
  while (!isConnected() && !jobs_.empty()) finish(PartnerStatus::NoConnection);
  while (jobs_.size() > kMostJobs) {
    program_.finished({jobs_.back().number, PartnerStatus::TooManyJobs});
    jobs_.pop_back();
  }
  if (!busy_) next();
}

// What the partner still has to answer is waited for, and told to nobody.
void Partner::restart() {
  receivers_.clear();
  listeners_.clear();
  jobs_.erase(jobs_.begin() + (busy_ ? 1 : 0), jobs_.end());
  dropped_ = told_ = busy_;
}

void Partner::set(const Receiver& receiver) {
  if (receiver.blocks) return receivers_.set(receiver);
  if (receiver.removed || !receiver.enabled)
    listeners_.erase(receiver.rid);
  else if (listeners_.size() < BlockReceivers::kMost)
    listeners_.insert(receiver.rid);
}

// The program is told at once; a telegram ends behind the segment that is on its way.
void Partner::abort(std::uint32_t number) {
  const auto found = std::ranges::find(jobs_, number, &PartnerJob::number);
  if (found == jobs_.end()) return;
  program_.finished({number, PartnerStatus::Reset});
  if (busy_ && found == jobs_.begin())
    dropped_ = told_ = true;
  else
    jobs_.erase(found);
}

void Partner::next() {
  while (isConnected() && !busy_ && !jobs_.empty()) {
    busy_ = true;
    sent_ = 0;
    sequence_ = unit_ = 0;
    if (job().kind == Kind::BlockSend) {
      sendSegment();
      continue;
    }
    if (job().kind == Kind::Send) {
      sendNotice();
      continue;
    }
    const Bytes request = requestOf(job(), ++reference_);
    if (request.size() > pdu_)
      finish(PartnerStatus::WrongLength);
    else
      send_(request);
  }
}

void Partner::sendSegment() {
  const Bytes& telegram = job().values.front();
  const bool first = sent_ == 0;
  const std::size_t count = std::min(segmentRoom(pdu_, first), telegram.size() - sent_);
  Segment segment{.rid = job().rid,
                  .sequence = sequence_,
                  .last = sent_ + count == telegram.size(),
                  .octets = View(telegram).subspan(sent_, count)};
  if (first) segment.total = static_cast<std::uint16_t>(telegram.size());
  if (!first || !segment.last) segment.unit = unit_ = static_cast<std::uint8_t>(unit_ % 0xFF + 1);
  sent_ += count;
  send_(writeSegment(++reference_, segment));
}

// It is done when it is sent.
void Partner::sendNotice() {
  const Bytes bytes = writeNotice(++reference_, job().rid, job().areas);
  const bool fits = bytes.size() <= pdu_;
  if (fits) send_(bytes);
  finish(fits ? PartnerStatus::Done : PartnerStatus::WrongLength);
}

Partner::Heard Partner::receive(View bytes) {
  const auto pdu = readPdu(bytes);
  if (!pdu) return Heard::NotMine;
  if (isNotice(*pdu)) return hearNotice(*pdu);
  switch (blockPdu(*pdu)) {
    case BlockPdu::Answer:
      return hearSegmentAnswer(*pdu);
    case BlockPdu::Segment:
      if (!isConnected()) return Heard::Wrong;
      hearSegment(*pdu);
      return Heard::Done;
    case BlockPdu::None:
      return hearAnswer(*pdu);
  }
  return Heard::NotMine;
}

Partner::Heard Partner::hearAnswer(const Pdu& pdu) {
  const bool answer = pdu.type == PduType::Answer || pdu.type == PduType::Acknowledge;
  if (!answer || pdu.reference != reference_ || !asks()) return Heard::NotMine;
  if (setupAsked_) return hearSetup(pdu);
  if (job().kind == Kind::BlockSend) return Heard::NotMine;
  hearVariables(pdu);
  next();
  return Heard::Done;
}

Partner::Heard Partner::hearSetup(const Pdu& pdu) {
  constexpr std::uint16_t kShortest = 112;  // as this side accepts it
  setupAsked_ = false;
  const auto offer = setupAnswer(pdu);
  if (!offer || offer->pdu < kShortest) return Heard::Wrong;
  agreed(std::min(offer->pdu, wanted_));  // an answer that offers more does not count
  return Heard::Done;
}

// One that fails refuses them all.
void Partner::hearVariables(const Pdu& pdu) {
  const std::size_t count = job().items.size();
  std::vector<Bytes> values;
  std::vector<ItemCode> codes;
  if (job().kind == Kind::Get) {
    for (Value& value : readAnswer(pdu).value_or(std::vector<Value>())) {
      codes.push_back(value.code);
      values.push_back(std::move(value.octets));
    }
  } else {
    codes = writeAnswer(pdu).value_or(std::vector<ItemCode>());
  }
  if (codes.size() != count) return finish(PartnerStatus::Refused);
  const bool done = std::ranges::all_of(codes, [](auto code) { return code == ItemCode::Done; });
  finish(done ? PartnerStatus::Done : PartnerStatus::NoAccess, std::move(values));
}

Partner::Heard Partner::hearSegmentAnswer(const Pdu& pdu) {
  const auto answer = readSegmentAnswer(pdu);
  const bool mine = busy_ && job().kind == Kind::BlockSend && pdu.reference == reference_;
  if (!mine || !answer) return Heard::Wrong;
  const bool all = sent_ == job().values.front().size();
  const bool over = answer->error != Error::None || all || dropped_;
  if (!over && answer->sequence == 0) return Heard::Wrong;  // a first segment has that
  if (over) {
    finish(statusOf(answer->error));
    next();
  } else {
    sequence_ = answer->sequence;
    sendSegment();
  }
  return Heard::Done;
}

void Partner::hearSegment(const Pdu& pdu) {
  const auto segment = readSegment(pdu);
  if (!segment) return send_(writeSegmentAnswer(pdu.reference, {0, Error::WrongPduSize}));
  BlockReceivers::Taken taken = receivers_.take(*segment);
  send_(writeSegmentAnswer(pdu.reference, taken.answer));
  if (taken.whole)
    program_.arrived(std::move(*taken.whole));
  else if (taken.answer.error == Error::None)
    program_.begun(segment->rid, taken.octets);
}

// Nobody learns of one that no block receives.
Partner::Heard Partner::hearNotice(const Pdu& pdu) {
  if (!isConnected()) return Heard::Wrong;
  auto notice = readNotice(pdu);
  if (notice && listeners_.contains(notice->rid)) program_.noticed(std::move(*notice));
  return Heard::Done;
}

}  // namespace merker::s7comm
