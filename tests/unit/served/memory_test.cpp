// A panel that reads 207 values a second and writes one, in virtual time: memory stays what it is
// (a whole day of it: bench/s7/day.cpp).
#include "s7comm/request.h"
#include "s7comm/session.h"
#include "served_plc.h"

#ifdef __SANITIZE_ADDRESS__
// Of the sanitizer's run-time library; GCC comes without its header.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#else
#include <malloc.h>
#endif

namespace merker::served {
namespace {

std::size_t bytesInUse() {
#ifdef __SANITIZE_ADDRESS__
  return __sanitizer_get_current_allocated_bytes();
#else
  return mallinfo2().uordblks;
#endif
}

class Panel {
 public:
  Panel() {
    plc_.exchange.opened();
    session_->receive(s7comm::setupRequest(++reference_, {}));
    plc_.cycles(2);
  }
  ~Panel() {
    session_->end();
    plc_.exchange.closed();
  }
  Panel(const Panel&) = delete;

  void seconds(int count) {
    for (; count > 0; --count) second();
  }
  std::size_t values = 0, writes = 0;

 private:
  static s7comm::AnyItem flag(std::uint32_t byte) {
    return {.type = s7comm::ElementType::Word, .memory = Memory::Flag, .address = byte * 8};
  }
  void second() {
    constexpr int kValues = 207, kOfARequest = 18;
    for (int left = kValues; left > 0; left -= kOfARequest)
      session_->receive(s7comm::readRequest(
          ++reference_, std::vector<s7comm::AnyItem>(std::min(left, kOfARequest), flag(10))));
    const s7comm::AnyItem item = flag(100);
    const Bytes value = {0, static_cast<std::uint8_t>(reference_)};
    session_->receive(s7comm::writeRequest(++reference_, {&item, 1}, {&value, 1}));
    plc_.plc().advanceTo(plc_.plc().now() + Duration::seconds(1));
  }
  void hear(const Bytes& octets) {
    const auto pdu = s7comm::readPdu(octets);
    if (const auto read = s7comm::readAnswer(*pdu)) values += read->size();
    if (const auto written = s7comm::writeAnswer(*pdu)) writes += written->size();
  }

  ServedPlc plc_ = ServedPlc::station();
  std::uint16_t reference_ = 0;
  std::shared_ptr<s7comm::Session> session_ =
      std::make_shared<s7comm::Session>(plc_.exchange, [this](const Bytes& pdu) { hear(pdu); });
};

TEST(ServedMemory, isFlatWhileAPanelReads) {
  constexpr std::size_t kTolerated = 4'096;  // bytes: a diagnostic entry, a deque's next piece
  Panel panel;
  panel.seconds(20);
  const std::size_t before = bytesInUse();
  panel.seconds(60);
  EXPECT_LE(bytesInUse(), before + kTolerated);
  EXPECT_EQ(panel.values, 80u * 207);
  EXPECT_EQ(panel.writes, 80u);
}

}  // namespace
}  // namespace merker::served
