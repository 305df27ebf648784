// The services of the side that is asked: one row each.
#pragma once

#include "s7comm/session.h"

namespace merker::s7comm {

struct UserdataHead;

// A request, and what its answer needs. Copies may wait for the PLC.
struct Job {
  std::shared_ptr<Session> session;
  PduType type = PduType::Job;
  std::uint16_t reference = 0;
  std::uint8_t function = 0;
  View parameters{}, data{};  // of the request, while it is served; then there are none

  Plc& plc() const { return session->plc_; }
  const Offer& offer() const { return session->offer_; }
  std::uint16_t pdu() const { return session->pdu_; }
  void agree(std::uint16_t pdu, std::uint16_t jobs) const { session->agree(pdu, jobs); }

  void answer(View answerParameters, View answerData = {}, Error error = Error::None) const;
  void refuse(Error error) const;
  void userdata(const UserdataHead& head, View octets) const;
  const std::shared_ptr<Outlet>& outlet() const { return session->outlet(); }
  Rests& rests() const { return session->rests_; }
  const Session::Guard& guard() const { return session->guard_; }
  std::string& password() const { return session->password_; }
  Session::Upload& upload() const { return session->upload_; }
  Session::Download& download() const { return session->download_; }
  // A job of this side; its answer comes later, or never.
  void ask(View jobParameters, Session::Heard heard) const { session->ask(jobParameters, heard); }

  // The PLC carries it out: what waits for its answer, then that it was given.
  Job begun() const {
    ++session->waiting_;
    Job job = *this;
    job.parameters = job.data = {};
    return job;
  }
  void ended() const { session->answered(); }
};

struct Service {
  std::uint8_t function;
  const char* name;
  bool waits;        // for the jobs before it, whose effect it must see
  bool beforeSetup;  // it is served without one
  void (*serve)(const Job& job);
};

// Null: there is none.
const Service* findService(std::uint8_t function);

void serveSetup(const Job& job);
void serveRead(const Job& job);
void serveWrite(const Job& job);
void serveUserdata(const Job& job);
void serveProgramInvocation(const Job& job);
void serveStop(const Job& job);
void serveRequestDownload(const Job& job);
void serveStartUpload(const Job& job);
void serveUpload(const Job& job);
void serveEndUpload(const Job& job);

}  // namespace merker::s7comm
