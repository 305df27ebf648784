// The receive buffer.
#include "stations.h"

namespace merker::serial {
namespace {

MailboxParameters limited(std::uint8_t telegrams, bool prevent) {
  return {.preventOverwriting = prevent, .wholeBuffer = false, .telegrams = telegrams};
}

Bytes of(std::uint8_t value, std::size_t count = 1) { return Bytes(count, value); }

std::string all(Mailbox& mailbox) {
  std::string result;
  while (const auto entry = mailbox.take())
    result += (result.empty() ? "" : "; ") +
              (entry->event == Event::None ? text(entry->telegram) : number(entry->event));
  return result;
}

// PTP-PARAM-22, PTP-ASCII-22
TEST(SerialMailbox, HoldsTwoThousandTelegramsOfOneByte) {
  Mailbox mailbox;
  for (unsigned i = 0; i < 2048; ++i)
    ASSERT_EQ(mailbox.put(of(static_cast<std::uint8_t>(i))), Event::None);
  EXPECT_FALSE(mailbox.free());
  EXPECT_EQ(mailbox.put(of(1)), Event::Overflow);
  EXPECT_EQ(mailbox.take()->event, Event::NearlyFull);
  for (unsigned i = 0; i < 2048; ++i)
    ASSERT_EQ(mailbox.take()->telegram, of(static_cast<std::uint8_t>(i)));
  EXPECT_FALSE(mailbox.take());
}

// PTP-PARAM-21, PTP-PARAM-23, PTP-ASCII-24, PTP-ERR-48
TEST(SerialMailbox, RefusesTheEleventhTelegram) {
  Mailbox mailbox(limited(10, true));
  for (std::uint8_t i = 1; i <= 10; ++i) EXPECT_EQ(mailbox.put(of(i)), Event::None);
  EXPECT_FALSE(mailbox.free());
  EXPECT_EQ(mailbox.put(of(11)), Event::Lost);
  EXPECT_EQ(all(mailbox), "01; 02; 03; 04; 05; 06; 07; 08; 09; 0A");
}

// PTP-ASCII-25, PTP-PARAM-21
TEST(SerialMailbox, OverwritesTheOldest) {
  Mailbox mailbox(limited(10, false));
  for (std::uint8_t i = 1; i <= 11; ++i) {
    EXPECT_TRUE(mailbox.free());
    EXPECT_EQ(mailbox.put(of(i)), Event::None);
  }
  EXPECT_EQ(all(mailbox), "02; 03; 04; 05; 06; 07; 08; 09; 0A; 0B");
  Mailbox whole({.preventOverwriting = false});
  whole.put(of(1, 1024));
  whole.put(of(2, 1024));
  whole.put(of(3, 2));
  whole.take();  // the warning
  EXPECT_EQ(whole.take()->telegram, of(2, 1024));
}

// PTP-ASCII-23
TEST(SerialMailbox, NewestOnly) {
  Mailbox mailbox(limited(1, false));
  for (std::uint8_t i = 1; i <= 5; ++i) mailbox.put(of(i));
  EXPECT_EQ(all(mailbox), "05");
}

// PTP-ASCII-26, PTP-ERR-63
TEST(SerialMailbox, WarnsAboveTwoThirdsAndAgainAfterItWasEmptied) {
  Mailbox mailbox;
  mailbox.put(of(1, 1000));
  mailbox.put(of(2, 365));
  EXPECT_EQ(mailbox.take()->telegram.size(), 1000U);
  mailbox.put(of(1, 1000));
  EXPECT_EQ(mailbox.bytes(), 1365U);
  mailbox.put(of(3, 1));
  EXPECT_EQ(number(mailbox.take()->event), "0B01");
  EXPECT_EQ(mailbox.take()->telegram.size(), 365U);
  mailbox.put(of(4, 365));
  EXPECT_EQ(number(mailbox.take()->event), "0B01");
}

// SFB61-10
TEST(SerialMailbox, ErrorsStandBetweenTheTelegramsTheOldestSixteen) {
  Mailbox mailbox;
  mailbox.put(of(1));
  mailbox.report(Event::CharacterDelay);
  mailbox.put(of(2));
  EXPECT_EQ(all(mailbox), "01; 0806; 02");
  mailbox.report(Event::Break);
  for (unsigned i = 0; i < 20; ++i) mailbox.report(Event::CharacterDelay);
  const std::string shown = all(mailbox);
  EXPECT_EQ(shown.substr(0, 10), "080D; 0806");
  EXPECT_EQ(shown.size(), 16U * 6 - 2);
}

// PTP-ASCII-27, SFB62-02, PTP-PARAM-20
TEST(SerialMailbox, IsClearedByAJobAndAtStartUpIfSoSet) {
  Mailbox kept, cleared({.clearAtStart = true});
  for (Mailbox* mailbox : {&kept, &cleared}) {
    mailbox->put(of(1, 1500));
    mailbox->refuse(true);
    EXPECT_FALSE(mailbox->free());
    EXPECT_EQ(mailbox->put(of(2)), Event::Lost);
    mailbox->start();
    EXPECT_TRUE(mailbox->free());
  }
  EXPECT_EQ(kept.telegrams(), 1U);
  EXPECT_EQ(cleared.telegrams(), 0U);
  kept.clear();
  EXPECT_EQ(kept.bytes(), 0U);
  EXPECT_EQ(kept.put(of(3, 1024)), Event::None);
}

}  // namespace
}  // namespace merker::serial
