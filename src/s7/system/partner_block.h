// What the blocks of configured connections have in common: a job from the edge of REQ to its
// result, and the R_ID of a receiving block.
#pragma once

#include <utility>
#include <vector>

#include "system/call.h"
#include "system/connections.h"
#include "system/partner_memory.h"

namespace merker::system {

using s7comm::PartnerJob;
using s7comm::PartnerStatus;

// STATUS with ERROR = 0.
constexpr std::uint32_t kOverwritten = 9, kStillRuns = 11, kBytesCome = 17, kJobRuns = 25;

inline Connections::Instance instanceOfCall(Arguments& a) {
  const cpu::Registers& r = a.machine().registers;
  return static_cast<std::uint32_t>(r.di.number) << 16 | (r.ar2 >> 3 & 0xFFFF);
}

// `done`: DONE or NDR.
template <typename A>
void showDone(A& a, NameIn<A> done, bool is, std::uint32_t status = 0) {
  a.set(done, is);
  a.set("ERROR", 0);
  a.set("STATUS", status);
}

template <typename A>
void showFailed(A& a, NameIn<A> done, PartnerStatus status) {
  a.set(done, 0);
  a.set("ERROR", 1);
  a.set("STATUS", static_cast<std::uint32_t>(status));
  a.fail();
}

// A job as its block makes it, or why it cannot.
struct Made {
  PartnerStatus status = PartnerStatus::Done;
  PartnerJob job{};
};

template <typename A>
void beginJob(A& a, NameIn<A> done, Connections::Sender& sender, Made (*make)(A&)) {
  const auto connection = a.connections().find(a.value("ID"));
  if (!connection || !a.connections().connected(*connection))
    return showFailed(a, done, PartnerStatus::NoConnection);
  Made made = make(a);
  if (made.status != PartnerStatus::Done) return showFailed(a, done, made.status);
  a.connections().begin(sender, *connection, std::move(made.job));
  showDone(a, done, false, kJobRuns);
}

// An edge of REQ that comes with the result begins the next job in the next call.
template <typename A>
void endJob(A& a, NameIn<A> done, Connections::Sender& sender, bool edge,
            PartnerStatus (*store)(A&, const std::vector<s7comm::Bytes>&)) {
  const s7comm::PartnerResult result = std::move(*sender.result);
  sender.job.reset();
  sender.result.reset();
  if (edge) sender.request = false;
  const PartnerStatus status =
      result.status == PartnerStatus::Done ? store(a, result.values) : result.status;
  status == PartnerStatus::Done ? showDone(a, done, true) : showFailed(a, done, status);
}

template <typename A>
void carryOutJob(A& a, NameIn<A> done, bool reset, Made (*make)(A&),
                 PartnerStatus (*store)(A&, const std::vector<s7comm::Bytes>&)) {
  Connections::Sender* const sender = a.connections().sender(instanceOfCall(a));
  if (sender == nullptr) return showFailed(a, done, PartnerStatus::TooManyJobs);
  const bool request = a.flag("REQ");
  const bool edge = request && !std::exchange(sender->request, request);
  const bool resetEdge = reset && !std::exchange(sender->reset, reset);
  sender->request = request;
  sender->reset = reset;
  if (sender->result) return endJob(a, done, *sender, edge, store);
  if (sender->job) {
    if (resetEdge) a.connections().abort(*sender);
    return showDone(a, done, false, edge ? kStillRuns : kJobRuns);
  }
  if (!edge) return showDone(a, done, false);
  beginJob(a, done, *sender, make);
}

template <typename A>
PartnerStatus nothingToStore(A&, const std::vector<s7comm::Bytes>&) {
  return PartnerStatus::Done;
}

// The connection and R_ID of a receiver, as they are in this call; Done: it has them.
template <typename A>
PartnerStatus bindReceiver(A& a, Connections::Receiver& receiver, bool blocks) {
  Connections& all = a.connections();
  const auto connection = all.find(a.value("ID"));
  const std::uint32_t rid = a.value("R_ID");
  const bool same =
      receiver.connection == connection && receiver.rid == rid && receiver.blocks == blocks;
  if (receiver.connection && !same) all.release(receiver);
  if (!connection) return PartnerStatus::NoConnection;
  const bool bound = receiver.connection || all.bind(receiver, *connection, rid, blocks);
  return bound ? PartnerStatus::Done : PartnerStatus::Occupied;
}

}  // namespace merker::system
