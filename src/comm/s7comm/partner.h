// A configured connection, of either side: jobs of the program go to the partner one after the
// other, its telegrams come in. It outlives the transport connections, of which it has one at a
// time, or none. What the partner asks as a client is for a Session beside it.
#pragma once

#include <deque>
#include <functional>
#include <set>

#include "s7comm/block_receivers.h"
#include "s7comm/session.h"

namespace merker::s7comm {

// The program, as the partner meets it: what it is told comes to it later.
class PartnerProgram {
 public:
  virtual ~PartnerProgram() = default;
  virtual void connected(bool is) = 0;
  virtual void finished(PartnerResult result) = 0;
  virtual void begun(std::uint32_t rid, std::size_t octets) = 0;
  virtual void arrived(Telegram telegram) = 0;
  virtual void noticed(Notice notice) = 0;

 protected:
  PartnerProgram() = default;
  PartnerProgram(const PartnerProgram&) = default;
  PartnerProgram& operator=(const PartnerProgram&) = default;
};

class Partner {
 public:
  static constexpr std::size_t kMostJobs = 64;

  // `program` outlives it.
  explicit Partner(PartnerProgram& program) : program_(program) {}

  // A transport connection is there; PDUs go this way.
  void attach(Session::Send send) { send_ = std::move(send); }
  bool attached() const { return send_ != nullptr; }
  // The calling side asks for the setup.
  void setUp(const Offer& wanted);
  // Both sides have agreed.
  void agreed(std::uint16_t pdu);
  bool isConnected() const { return pdu_ != 0; }
  std::uint16_t pdu() const { return pdu_; }
  // The transport connection has gone: jobs end, telegrams that have begun are lost.
  void detach();

  enum class Heard : std::uint8_t { NotMine, Done, Wrong };  // Wrong: it is no partner
  Heard receive(View bytes);
  // It has not answered yet.
  bool asks() const { return setupAsked_ || busy_; }

  // From the program.
  void order(ToPartner orders);

 private:
  void restart();
  void set(const Receiver& receiver);
  void abort(std::uint32_t number);
  void next();
  void sendSegment();
  void sendNotice();
  void finish(PartnerStatus status, std::vector<Bytes> values = {});
  Heard hearAnswer(const Pdu& pdu);
  Heard hearSetup(const Pdu& pdu);
  void hearVariables(const Pdu& pdu);
  Heard hearSegmentAnswer(const Pdu& pdu);
  void hearSegment(const Pdu& pdu);
  Heard hearNotice(const Pdu& pdu);
  PartnerJob& job() { return jobs_.front(); }

  PartnerProgram& program_;
  Session::Send send_;
  BlockReceivers receivers_;
  std::set<std::uint32_t> listeners_;  // R_IDs of the enabled URCV
  std::uint16_t pdu_ = 0, reference_ = 0;
  bool setupAsked_ = false;
  std::uint16_t wanted_ = 0;     // PDU that was asked for
  std::deque<PartnerJob> jobs_;  // the first one runs if busy_
  bool busy_ = false;
  bool dropped_ = false;  // what runs is for nobody: R, or a restart
  bool told_ = false;     // the program has its result already
  std::size_t sent_ = 0;  // octets of its telegram
  std::uint8_t sequence_ = 0, unit_ = 0;
};

}  // namespace merker::s7comm
