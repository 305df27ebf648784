#include "store/memory_card.h"

#include <filesystem>
#include <set>
#include <utility>

#include "block/container.h"
#include "store/header.h"
#include "store/pages.h"

namespace merker::store {
namespace {

namespace fs = std::filesystem;

// All in one transaction with the old journal, so that the header of the file says what it is from
// the beginning; then the write-ahead log. A commit is safe from the end of the process at once;
// synchronous = NORMAL also keeps the database whole when the machine itself loses power, at the
// price that the very last cycles may then be missing (docs/formats/card.md).
constexpr const char* kCreate =
    "PRAGMA page_size = 1024;"
    "BEGIN EXCLUSIVE;"
    "CREATE TABLE block(kind INTEGER, number INTEGER, read_only INTEGER, container BLOB,"
    " checksum INTEGER, PRIMARY KEY(kind, number));"
    "CREATE TABLE setting(name TEXT PRIMARY KEY, value BLOB, checksum INTEGER);"
    "CREATE TABLE area(kind TEXT, number INTEGER, length INTEGER, PRIMARY KEY(kind, number));"
    "CREATE TABLE page(kind TEXT, number INTEGER, page INTEGER, bytes BLOB, checksum INTEGER,"
    " PRIMARY KEY(kind, number, page)) WITHOUT ROWID;"
    "PRAGMA application_id = 0x4D524B43;"
    "PRAGMA user_version = 1;"
    "COMMIT;";
constexpr const char* kWriting =
    "PRAGMA journal_mode = WAL;"
    "PRAGMA synchronous = NORMAL;"
    "PRAGMA wal_autocheckpoint = 4000;";

Problem problemOf(const DatabaseError& error, ProblemCode otherwise, const Position& at) {
  if (error.code == SQLITE_BUSY) return makeProblem(ProblemCode::P1004, at);
  if (error.code == SQLITE_NOTADB)
    return makeProblem(ProblemCode::P1002, at, "card.sqlite in it is no database");
  const bool damaged = error.code == SQLITE_CORRUPT || error.code == SQLITE_ERROR;
  return makeProblem(damaged ? ProblemCode::P1003 : otherwise, at, std::string(error.what()));
}

// Runs what may fail inside; its failures are problems outside.
template <typename T, typename Work>
Result<T> guarded(const Position& at, ProblemCode otherwise, Work work) {
  try {
    return work();
  } catch (const DatabaseError& error) {
    return problemOf(error, otherwise, at);
  } catch (const Damage& damage) {
    return makeProblem(ProblemCode::P1003, at, std::string(damage.what()));
  }
}

std::optional<Problem> makeFolder(const std::string& folder, const Position& at) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    return makeProblem(ProblemCode::P1002, at, "it is a file; a memory card is a folder");
  fs::create_directories(folder, error);
  if (error) return makeProblem(ProblemCode::P1001, at, error.message());
  return std::nullopt;
}

void requireOrder(Database& database) {
  Statement check = database.prepare("PRAGMA quick_check(1)");
  if (!check.step()) return;
  if (const std::string found = check.text(0); found != "ok") throw Damage(found);
}

}  // namespace

struct MemoryCard::Parts {
  Parts(const std::string& folder, const std::string& file) : at{folder}, database(file) {}

  Position at;
  Database database;
  std::optional<Pages> pages;
  LoadMemory load;
  std::optional<block::RetentiveData> retentive;
  std::optional<std::uint64_t> eventsSaved;  // RetentiveData::eventsAdded of the last save

  bool isNew() { return database.integer("SELECT count(*) FROM sqlite_schema") == 0; }
  void readAll();
  void clear();
  void removeStale(const block::RetentiveData& data);
  void put(const block::RetentiveData& data);
};

void MemoryCard::Parts::readAll() {
  requireOrder(database);
  load = readLoadMemory(database);
  pages.emplace(database);
  const std::map<AreaId, Bytes> areas = pages->read();
  if (!areas.empty()) retentive = fromAreas(areas);
}

void MemoryCard::Parts::clear() {
  const std::map<AreaId, Bytes> areas = pages->known();
  for (const auto& [id, bytes] : areas) pages->remove(id);
  retentive.reset();
}

// Data blocks that are no longer there (SFC 23), or are now of another origin.
void MemoryCard::Parts::removeStale(const block::RetentiveData& data) {
  std::set<AreaId> wanted{kStateArea,   kFlagArea,  kTimerArea,
                          kCounterArea, kMeterArea, kDiagnosticArea};
  for (const block::RetentiveDataBlock& block : data.dataBlocks) wanted.insert(areaOf(block));
  std::vector<AreaId> stale;
  for (const auto& [id, bytes] : pages->known())
    if (!wanted.contains(id)) stale.push_back(id);
  for (const AreaId& id : stale) pages->remove(id);
}

void MemoryCard::Parts::put(const block::RetentiveData& data) {
  pages->put(kStateArea, stateBytes(data));
  pages->put(kFlagArea, data.flags);
  pages->put(kTimerArea, timerBytes(data));
  pages->put(kCounterArea, counterBytes(data));
  pages->put(kMeterArea, meterBytes(data));
  for (const block::RetentiveDataBlock& block : data.dataBlocks)
    pages->put(areaOf(block), block.bytes);
  if (eventsSaved != data.eventsAdded) pages->put(kDiagnosticArea, diagnosticBytes(data));
  eventsSaved = data.eventsAdded;
  constexpr std::size_t kOthers = 6;
  if (pages->known().size() > data.dataBlocks.size() + kOthers) removeStale(data);
}

MemoryCard::MemoryCard(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MemoryCard::MemoryCard(MemoryCard&&) noexcept = default;
MemoryCard& MemoryCard::operator=(MemoryCard&&) noexcept = default;
MemoryCard::~MemoryCard() = default;

Result<MemoryCard> MemoryCard::open(const std::string& folder) {
  const Position at{folder};
  if (auto problem = makeFolder(folder, at)) return *problem;
  const std::string file = (fs::path(folder) / "card.sqlite").string();
  if (const std::string why = whyNoCard(file); !why.empty())
    return makeProblem(ProblemCode::P1002, at, why);
  return guarded<MemoryCard>(at, ProblemCode::P1001, [&]() -> Result<MemoryCard> {
    auto parts = std::make_unique<Parts>(folder, file);
    Database& database = parts->database;
    database.checkpointOnClose(false);
    database.execute("PRAGMA locking_mode = EXCLUSIVE");
    if (parts->isNew()) database.execute(kCreate);
    if (const auto format = database.integer("PRAGMA user_version"); format > kFormat)
      return makeProblem(ProblemCode::P1005, at, format, kFormat);
    parts->readAll();
    database.execute(kWriting);
    database.checkpointOnClose(true);
    return MemoryCard(std::move(parts));
  });
}

bool MemoryCard::empty() const { return parts_->load.program.empty(); }
const LoadMemory& MemoryCard::loadMemory() const { return parts_->load; }
const std::optional<block::RetentiveData>& MemoryCard::retentive() const {
  return parts_->retentive;
}

Result<Download> MemoryCard::download(LoadMemory wanted) {
  Parts& p = *parts_;
  for (const auto& [id, block] : wanted.program)
    if (hasContainer(block) && block::writeContainer(block).empty())
      return makeProblem(ProblemCode::P1008, p.at, toString(id));
  return guarded<Download>(p.at, ProblemCode::P1006, [&] {
    Transaction transaction(p.database);
    const Download done = writeLoadMemory(p.database, wanted);
    if (done.anotherCpu) p.clear();
    for (const auto* blocks : {&done.loaded, &done.deleted})
      for (const BlockId id : *blocks)
        if (id.kind == BlockKind::DB)
          for (const char* kind : {"DB", "made DB"}) p.pages->remove({kind, id.number});
    transaction.commit();
    p.load = std::move(wanted);
    const std::map<AreaId, Bytes> areas = p.pages->known();
    if (!areas.empty()) p.retentive = fromAreas(areas);
    return done;
  });
}

std::optional<Problem> MemoryCard::save(const block::RetentiveData& data) {
  Parts& p = *parts_;
  const auto saved = guarded<bool>(p.at, ProblemCode::P1006, [&] {
    Transaction transaction(p.database);
    p.put(data);
    transaction.commit();
    return true;
  });
  if (saved) return std::nullopt;
  return saved.error();
}

}  // namespace merker::store
