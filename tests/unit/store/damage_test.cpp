// Damaged and foreign cards: a problem, never a crash, and nothing written to them.
#include <sys/stat.h>

#include <fstream>
#include <iterator>
#include <random>

#include "card.h"
#include "store/database.h"

namespace merker::store::test {
namespace {

namespace fs = std::filesystem;

class DamagedCard : public CardTest {
 protected:
  DamagedCard() {
    auto card = MemoryCard::open(folder_);
    EXPECT_TRUE(card->download(loadMemory()));
    EXPECT_FALSE(card->save(retentiveData(7)));
  }
  std::string content() const {
    std::ifstream in(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  void replace(const std::string& bytes) const {
    fs::remove(file() + "-wal");
    std::ofstream(file(), std::ios::binary) << bytes;
  }
  // As format 1 was: without the sum of what belongs together.
  void makeOld() const {
    execute("DELETE FROM setting WHERE name = 'contents'; PRAGMA user_version = 1");
  }
  void execute(const char* sql) const { Database(file()).execute(sql); }
  // Refused for this reason, and the file is as it was.
  void expectRefusal(ProblemCode code) const {
    const std::string before = content();
    EXPECT_EQ(refusal(), code);
    EXPECT_TRUE(content() == before);
  }
};

TEST_F(DamagedCard, TextIsNoDatabase) {
  replace("this is text and no database, long enough for a header: " + std::string(200, '.'));
  expectRefusal(ProblemCode::P1002);
  replace("short");
  expectRefusal(ProblemCode::P1002);
}

TEST_F(DamagedCard, ADatabaseOfAnotherProgram) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  execute("CREATE TABLE recipe(name TEXT); INSERT INTO recipe VALUES ('bread');");
  expectRefusal(ProblemCode::P1002);
}

// Database file format of SQLite, section 1.3.2: a page has 512 bytes or more.
TEST_F(DamagedCard, AHeaderThatNoDatabaseHas) {
  std::string bytes = content();
  bytes.at(16) = 0;
  bytes.at(17) = 3;
  replace(bytes);
  expectRefusal(ProblemCode::P1002);
}

TEST_F(DamagedCard, AnEmptyFileIsANewCard) {
  replace("");
  const auto card = MemoryCard::open(folder_);
  ASSERT_TRUE(card);
  EXPECT_TRUE(card->empty());
}

TEST_F(DamagedCard, ANewerFormat) {
  execute("PRAGMA user_version = 3");
  expectRefusal(ProblemCode::P1005);
}

// Without a program to be put on it a card must have one, and nothing is made.
TEST_F(DamagedCard, NoProgramOnIt) {
  const auto refused = [&] {
    const auto card = MemoryCard::openLoaded(folder_);
    return !card && card.error().code == ProblemCode::P1007;
  };
  EXPECT_TRUE(MemoryCard::openLoaded(folder_));
  replace("");
  EXPECT_TRUE(refused());
  EXPECT_EQ(content(), "");
  fs::remove(file());
  EXPECT_TRUE(refused());
  EXPECT_FALSE(fs::exists(file()));
  fs::remove_all(folder_);
  EXPECT_TRUE(refused());
  EXPECT_FALSE(fs::exists(folder_));
  EXPECT_TRUE(MemoryCard::open(folder_));
  EXPECT_TRUE(refused());
}

// Every row that is left is right.
TEST_F(DamagedCard, WhatIsMissing) {
  const std::string whole = content();
  const char* const gone[] = {
      "DELETE FROM setting",
      "DELETE FROM setting WHERE name = 'cpu'",
      "DELETE FROM setting WHERE name = 'configuration'",
      "DELETE FROM setting WHERE name = 'contents'",
      "UPDATE setting SET value = x'', checksum = 0 WHERE name = 'cpu'",
      "DELETE FROM block",
      "DELETE FROM block WHERE kind = 12",
      "UPDATE block SET read_only = 0",
      "UPDATE block SET read_only = 1",
      "DELETE FROM area; DELETE FROM page",
      "DELETE FROM area WHERE kind = 'made DB'; DELETE FROM page WHERE kind"
      " = 'made DB'",
      "UPDATE area SET length = 512 WHERE number = 1; DELETE FROM page WHERE"
      " number = 1 AND page = 2",
      "UPDATE area SET kind = 'DB' WHERE kind = 'made DB'; UPDATE page SET"
      " kind = 'DB' WHERE kind = 'made DB'"};
  for (const char* sql : gone) {
    SCOPED_TRACE(sql);
    execute(sql);
    expectRefusal(ProblemCode::P1003);
    replace(whole);
  }
  EXPECT_TRUE(MemoryCard::open(folder_));
}

TEST_F(DamagedCard, WhatIsMissingInFormat1) {
  makeOld();
  const std::string whole = content();
  for (const std::string kind : {"state", "M", "T", "Z", "meters", "diagnostics", "DB"}) {
    SCOPED_TRACE(kind);
    execute(("DELETE FROM area WHERE kind = '" + kind + "'; DELETE FROM page WHERE kind = '" +
             kind + "'")
                .c_str());
    expectRefusal(ProblemCode::P1003);
    replace(whole);
  }
  for (const char* sql :
       {"DELETE FROM setting", "UPDATE setting SET value = x'', checksum = 0 WHERE name = 'cpu'",
        "UPDATE area SET length = 512 WHERE number = 1; DELETE FROM page WHERE number = 1 AND page"
        " = 2"}) {
    SCOPED_TRACE(sql);
    execute(sql);
    expectRefusal(ProblemCode::P1003);
    replace(whole);
  }
}

// Read as it is; the first save makes the newer format of it.
TEST_F(DamagedCard, Format1IsReadAndBroughtUpToDate) {
  makeOld();
  const std::string old = content();
  EXPECT_EQ(*MemoryCard::open(folder_)->retentive(), withoutCount(retentiveData(7)));
  EXPECT_TRUE(content() == old);
  EXPECT_FALSE(MemoryCard::open(folder_)->save(retentiveData(7)));
  EXPECT_EQ(*MemoryCard::open(folder_)->retentive(), withoutCount(retentiveData(7)));
  EXPECT_EQ(Database(file()).integer("PRAGMA user_version"), 2);
}

// Loaded, but never switched on; and with data blocks that came and went since it was loaded.
TEST_F(DamagedCard, WhatMayBeMissing) {
  fs::remove_all(folder_);
  EXPECT_TRUE(MemoryCard::open(folder_)->download(loadMemory()));
  EXPECT_FALSE(MemoryCard::openLoaded(folder_)->retentive());
  block::RetentiveData data = retentiveData(3);
  data.dataBlocks[0].bytes.resize(602);                // loaded online, longer
  data.dataBlocks.erase(data.dataBlocks.begin() + 1);  // SFC 23
  EXPECT_FALSE(MemoryCard::open(folder_)->save(data));
  EXPECT_EQ(*MemoryCard::openLoaded(folder_)->retentive(), withoutCount(data));
  LoadMemory load = loadMemory();  // changed, and the process ended before its first cycle
  load.program[{BlockKind::DB, 1}] = dataBlock(1, 600, 9);
  EXPECT_TRUE(MemoryCard::open(folder_)->download(load));
  EXPECT_EQ(MemoryCard::openLoaded(folder_)->retentive()->dataBlocks.size(), 1u);
}

TEST_F(DamagedCard, AFormatThatNeverWas) {
  for (const char* sql : {"PRAGMA user_version = 0", "PRAGMA user_version = -1"}) {
    execute(sql);
    expectRefusal(ProblemCode::P1003);
  }
}

void append(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
}

// A rollback journal of one page (database file format of SQLite, section 3): it comes into the
// file when SQLite opens it.
std::string journal(const std::string& page, std::size_t pages) {
  constexpr std::uint32_t kSector = 512, kNonce = 7;
  std::string bytes = "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7";
  for (const std::size_t value :
       {std::size_t{1}, std::size_t{kNonce}, pages, std::size_t{kSector}, page.size()})
    append(bytes, static_cast<std::uint32_t>(value));
  bytes.resize(kSector);
  append(bytes, 1);
  bytes += page;
  std::uint32_t sum = kNonce;
  for (std::size_t at = page.size() - 200; at < page.size(); at -= 200)
    sum += static_cast<std::uint8_t>(page[at]);
  append(bytes, sum);
  return bytes;
}

// What a journal makes of a card is looked at in a copy: one that is refused stays as it was.
TEST_F(DamagedCard, AJournalThatLeadsToANewerFormat) {
  constexpr std::size_t kPageSizeAt = 16, kUserVersionAt = 60;
  const std::string whole = content();
  const std::size_t length = static_cast<std::uint8_t>(whole.at(kPageSizeAt)) << 8;
  ASSERT_EQ(whole.size() % length, 0u);
  std::string page = whole.substr(0, length);
  page.at(kUserVersionAt + 3) = 3;
  const std::string name = file() + "-journal";
  std::ofstream(name, std::ios::binary) << journal(page, whole.size() / length);
  expectRefusal(ProblemCode::P1005);
  EXPECT_TRUE(fs::exists(name));
  Database(file()).execute("BEGIN IMMEDIATE; COMMIT");  // the journal was a real one
  EXPECT_FALSE(fs::exists(name));
  expectRefusal(ProblemCode::P1005);
}

// Nothing of it runs: only the texts of the schema are compared (tests/store/doctored_test.py has
// more).
TEST_F(DamagedCard, ASchemaThatNoCardHas) {
  const std::string endless =
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i";
  const std::string whole = content();
  for (const std::string& sql :
       {"DROP TABLE block; CREATE VIEW block(kind, number, read_only, container, checksum) AS " +
            endless + ", 1, 0, x'', 0 FROM n",
        std::string("CREATE TRIGGER t BEFORE INSERT ON page BEGIN SELECT RAISE(IGNORE); END"),
        std::string("CREATE INDEX i ON page(hex(bytes))"), std::string("CREATE TABLE t(a)"),
        std::string("ALTER TABLE area ADD COLUMN extra AS (length + 1)"),
        std::string("DROP TABLE setting; CREATE TABLE setting(name TEXT COLLATE NOCASE PRIMARY KEY,"
                    " value BLOB, checksum INTEGER)")}) {
    SCOPED_TRACE(sql);
    execute(sql.c_str());
    expectRefusal(ProblemCode::P1003);
    replace(whole);
  }
}

TEST_F(DamagedCard, NotARegularFile) {
  const std::string moved = folder_ + "/moved";
  fs::rename(file(), moved);
  ASSERT_EQ(::mkfifo(file().c_str(), 0600), 0);
  EXPECT_EQ(refusal(), ProblemCode::P1003);
  fs::remove(file());
  fs::create_symlink(moved, file());
  EXPECT_EQ(refusal(), ProblemCode::P1003);
  fs::remove(file());
  fs::create_directory(file());
  EXPECT_EQ(refusal(), ProblemCode::P1003);
  fs::remove(file());
  fs::rename(moved, file());
  EXPECT_TRUE(MemoryCard::open(folder_));
}

// A folder that is reached over a link is one as any other.
TEST_F(DamagedCard, AFolderBehindALink) {
  const std::string link = folder_ + "-link";
  fs::create_directory_symlink(folder_, link);
  EXPECT_TRUE(MemoryCard::open(link));
  fs::remove(link);
}

TEST_F(DamagedCard, ABudgetOfSteps) {
  Database database(file());
  database.setBudget(10);
  EXPECT_THROW((void)database.integer("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1"
                                      " FROM n) SELECT max(i) FROM n"),
               DatabaseError);
  database.setNoBudget();
  EXPECT_EQ(database.integer("SELECT count(*) FROM block"), 3);
}

TEST_F(DamagedCard, WhatThisModuleFinds) {
  for (const char* sql : {"UPDATE page SET bytes = x'00' WHERE kind = 'M'",
                          "DELETE FROM page WHERE kind = 'DB'",
                          "DELETE FROM page WHERE number = 1 AND page = 1",
                          "UPDATE area SET length = 5",
                          "UPDATE area SET number = -1 WHERE kind = 'M'",
                          "UPDATE area SET length = 1e12 WHERE kind = 'M'",
                          "UPDATE area SET kind = 'E' WHERE kind = 'M'",
                          "UPDATE page SET page = 1 WHERE kind = 'M'",
                          "UPDATE block SET container = x'7070'",
                          "UPDATE block SET checksum = 'x'",
                          "UPDATE block SET number = number + 1 WHERE kind = 12",
                          "UPDATE setting SET value = 5",
                          "UPDATE block SET kind = kind + 256",
                          "UPDATE block SET number = number + 65536",
                          "UPDATE block SET read_only = 2",
                          "UPDATE block SET container = 'text'",
                          "INSERT INTO setting VALUES ('extra', x'', 0)",
                          "INSERT INTO page VALUES ('DB', 77, -1, x'00', 3523407757)",
                          "DROP TABLE page",
                          "DROP TABLE block",
                          "ALTER TABLE area RENAME COLUMN kind TO sort"}) {
    SCOPED_TRACE(sql);
    const std::string whole = content();
    execute(sql);
    expectRefusal(ProblemCode::P1003);
    replace(whole);
  }
  EXPECT_TRUE(MemoryCard::open(folder_));
}

// Bytes changed at random, anywhere in the file, and files that are cut off: read or refused. What
// is read is right.
TEST_F(DamagedCard, AnyBytes) {
  const std::string whole = content();
  std::mt19937 random(314);
  std::size_t refused = 0;
  constexpr std::size_t kRounds = 400;
  for (std::size_t round = 0; round < kRounds; ++round) {
    std::string bytes = whole;
    for (std::size_t changes = 1 + random() % 8; changes > 0; --changes)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    if (round % 8 == 0) bytes.resize(random() % bytes.size());
    replace(bytes);
    auto card = MemoryCard::open(folder_);
    if (!card) {
      ++refused;
      EXPECT_FALSE(card.error().message.empty());
      EXPECT_TRUE(content() == bytes || bytes.empty()) << "round " << round;
      continue;
    }
    EXPECT_EQ(card->retentive().value_or(withoutCount(retentiveData(7))),
              withoutCount(retentiveData(7)));
    EXPECT_FALSE(card->save(retentiveData(8)));
  }
  EXPECT_GT(refused, kRounds / 4);
}

}  // namespace
}  // namespace merker::store::test
