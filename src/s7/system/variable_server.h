// What a CPU does for another CPU over a configured connection of the project: its variables are
// read and written (GET, PUT). It is asked at the end of a cycle or in STOP, so all is done at
// once; what programming devices ask for is not offered here.
#pragma once

#include "s7comm/plc.h"

namespace merker::cpu {
class Cpu;
}

namespace merker::system {

class VariableServer final : public s7comm::Plc {
 public:
  // `cpu` outlives it.
  explicit VariableServer(cpu::Cpu& cpu) : cpu_(cpu) {}

  void read(const std::vector<s7comm::Range>& ranges, ReadDone done) override;
  void write(std::vector<s7comm::Write> writes, WriteDone done) override;

  void status(std::uint16_t, std::uint16_t, StatusDone done) override { done({}); }
  void clock(ClockDone done) override { done(std::nullopt); }
  void setClock(const s7comm::ClockTime&, const std::string&, Done done) override { refuse(done); }
  void enter(const std::string&, Done done) override { refuse(done); }
  void control(s7comm::Control, const std::string&,
               std::function<void(s7comm::Controlled)> done) override {
    done(s7comm::Controlled::Refused);
  }
  void test(s7comm::TestRequest, std::shared_ptr<s7comm::Outlet>, TestDone done) override {
    done({.error = s7comm::Error::TestNotOffered});
  }
  void blocks(BlocksDone done) override { done(std::nullopt); }
  void blockHead(const s7comm::BlockName&, BlockDone done) override { refuse(done); }
  void block(const s7comm::BlockName&, const std::string&, BlockDone done) override {
    refuse(done);
  }
  void admit(const s7comm::BlockName&, std::size_t, const std::string&, Done done) override {
    refuse(done);
  }
  void keep(const s7comm::BlockName&, s7comm::Bytes, const std::string&, Done done) override {
    refuse(done);
  }
  void link(const std::vector<s7comm::BlockName>&, const std::string&, Done done) override {
    refuse(done);
  }
  void remove(const std::vector<s7comm::BlockName>&, const std::string&, Done done) override {
    refuse(done);
  }
  void subscribe(const std::shared_ptr<s7comm::Outlet>&, std::optional<std::uint8_t>,
                 s7comm::CyclicRead, SubscribeDone done) override {
    done(kNotOffered, 0, {});
  }
  void unsubscribe(const std::shared_ptr<s7comm::Outlet>&, std::uint8_t, Done done) override {
    refuse(done);
  }
  void listen(const std::shared_ptr<s7comm::Outlet>&, std::uint8_t, Done done) override {
    refuse(done);
  }
  void acknowledge(std::vector<std::uint32_t> numbers, CodesDone done) override {
    refuse(numbers, done);
  }
  void lock(std::vector<std::uint32_t> numbers, bool, CodesDone done) override {
    refuse(numbers, done);
  }
  void alarms(AlarmsDone done) override { done(std::nullopt); }

 private:
  static constexpr s7comm::Error kNotOffered = s7comm::Error::FunctionNotAvailable;
  static void refuse(const Done& done) { done(kNotOffered); }
  static void refuse(const BlockDone& done) { done(kNotOffered, {}); }
  static void refuse(const std::vector<std::uint32_t>& numbers, const CodesDone& done) {
    done(std::vector(numbers.size(), s7comm::ItemCode::AccessDenied));
  }

  cpu::Cpu& cpu_;
};

}  // namespace merker::system
