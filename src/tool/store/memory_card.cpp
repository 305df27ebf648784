#include "store/memory_card.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <filesystem>
#include <set>
#include <utility>

#include "block/container.h"
#include "store/card_file.h"
#include "store/contents.h"
#include "store/pages.h"
#include "store/schema.h"

namespace merker::store {
namespace {

namespace fs = std::filesystem;

// A commit is safe from the end of the process at once; synchronous = NORMAL also keeps the
// database whole when the machine itself loses power, at the price that the very last cycles may
// then be missing (docs/formats/card.md).
constexpr const char* kWriting =
    "PRAGMA journal_mode = WAL;"
    "PRAGMA synchronous = NORMAL;"
    "PRAGMA wal_autocheckpoint = 4000;";

// Thousands of steps: hundreds of times what the schema and the rows of a full card take.
constexpr std::int64_t kSchemaBudget = 100, kReadBudget = 50'000;

Problem problemOf(const DatabaseError& error, ProblemCode otherwise, const Position& at) {
  if (error.code == SQLITE_BUSY) return makeProblem(ProblemCode::P1004, at);
  if (error.code == SQLITE_NOTADB)
    return makeProblem(ProblemCode::P1002, at, "card.sqlite in it is not a database");
  if (error.code == SQLITE_INTERRUPT)
    return makeProblem(ProblemCode::P1003, at, "it contains more than a card can hold");
  const bool damaged = error.code == SQLITE_CORRUPT || error.code == SQLITE_ERROR ||
                       error.code == SQLITE_TOOBIG || error.code == SQLITE_SCHEMA;
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

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code error;
    const fs::path real = fs::canonical(fs::temp_directory_path(error), error);
    std::string pattern = (real / "merker-XXXXXX").string();
    if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code error;
    if (!path_.empty()) fs::remove_all(path_, error);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::optional<Problem> whyNoFolder(const std::string& folder, const Position& at) {
  std::error_code error;
  if (!fs::exists(folder, error) || fs::is_directory(folder, error)) return std::nullopt;
  return makeProblem(ProblemCode::P1002, at, "it is a file; a memory card is a folder");
}

std::optional<Problem> makeFolder(const std::string& folder, const Position& at) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return makeProblem(ProblemCode::P1001, at, error.message());
  return std::nullopt;
}

void requireOrder(Database& database) {
  Statement check = database.prepare("PRAGMA integrity_check(1)");
  if (!check.step()) return;
  if (const std::string found = check.text(0); found != "ok") throw Damage(found);
}

}  // namespace

struct MemoryCard::Parts {
  Parts(Position place, const std::string& path)
      : at(std::move(place)), file(path), log(path), database(path) {}

  Position at;
  std::string file;
  NewLog log;  // until the database is closed again
  Database database;
  std::optional<Pages> pages;
  std::optional<Contents> contents;
  std::int64_t format = 0;
  bool writing = false;
  LoadMemory load;
  std::optional<block::RetentiveData> retentive;
  std::optional<std::uint64_t> eventsSaved;  // RetentiveData::eventsAdded of the last save

  bool isNew() { return database.integer("PRAGMA page_count") == 0; }
  std::optional<Problem> check();
  void readAll();
  void beginWriting();
  void clear();
  void removeStale(const block::RetentiveData& data);
  void put(const block::RetentiveData& data);
};

// Before anything is read: the format, the tables, that the file is in order.
std::optional<Problem> MemoryCard::Parts::check() {
  database.setBudget(kSchemaBudget);
  format = database.integer("PRAGMA user_version");
  if (format > kFormat) return makeProblem(ProblemCode::P1005, at, format, kFormat);
  if (format < kOldestFormat) throw Damage(fmt::format("its format is {}", format));
  requireTables(database);
  const auto count = database.integer("PRAGMA page_count");
  const auto bytes = count * database.integer("PRAGMA page_size");
  if (fs::file_size(file) > static_cast<std::uintmax_t>(bytes))
    throw Damage(fmt::format("there are data after its {} pages", count));
  database.setBudget(kReadBudget);
  requireOrder(database);
  return std::nullopt;
}

void MemoryCard::Parts::readAll() {
  load = readLoadMemory(database);
  pages.emplace(database);
  contents.emplace(database, format);
  const std::map<AreaId, Bytes> areas = pages->read();
  contents->require(load, areas);
  if (!areas.empty()) retentive = fromAreas(areas);
}

void MemoryCard::Parts::beginWriting() {
  if (writing) return;
  database.execute(kWriting);
  database.checkpointOnClose(true);
  log.keep();
  writing = true;
}

void MemoryCard::Parts::clear() {
  const std::map<AreaId, Bytes> areas = pages->known();
  for (const auto& [id, bytes] : areas) pages->remove(id);
  retentive.reset();
}

// Data blocks that are no longer there (SFC 23), or are now of another origin.
void MemoryCard::Parts::removeStale(const block::RetentiveData& data) {
  std::set<AreaId> wanted = areasOfEachCard();
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
  if (pages->known().size() > data.dataBlocks.size() + areasOfEachCard().size()) removeStale(data);
  if (pages->takeChange() || contents->old()) contents->write(pages->known());
}

MemoryCard::MemoryCard(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MemoryCard::MemoryCard(MemoryCard&&) noexcept = default;
MemoryCard& MemoryCard::operator=(MemoryCard&&) noexcept = default;
MemoryCard::~MemoryCard() = default;

Result<MemoryCard> MemoryCard::open(const std::string& folder) {
  return open(folder, Empty::Allowed);
}

Result<MemoryCard> MemoryCard::openLoaded(const std::string& folder) {
  return open(folder, Empty::Refused);
}

Result<MemoryCard> MemoryCard::open(const std::string& folder, Empty empty) {
  const Position at{folder};
  if (auto problem = whyNoFolder(folder, at)) return *problem;
  std::error_code error;
  if (empty == Empty::Refused && !fs::exists(fs::symlink_status(folder + "/card.sqlite", error)))
    return makeProblem(ProblemCode::P1007, at);
  if (auto problem = makeFolder(folder, at)) return *problem;
  const fs::path real = fs::canonical(folder, error);
  if (error) return makeProblem(ProblemCode::P1001, at, error.message());
  const std::string file = (real / "card.sqlite").string();
  if (auto problem = whyNoCard(file, at)) return *problem;
  if (hasJournal(file))
    if (auto problem = whyNotTheCopy(file, at, empty)) return *problem;
  return openFile(file, at, empty);
}

Result<MemoryCard> MemoryCard::openFile(const std::string& file, const Position& at, Empty empty) {
  return guarded<MemoryCard>(at, ProblemCode::P1001, [&]() -> Result<MemoryCard> {
    auto parts = std::make_unique<Parts>(at, file);
    Database& database = parts->database;
    database.checkpointOnClose(false);
    database.execute("PRAGMA locking_mode = EXCLUSIVE");
    const bool isNew = parts->isNew();
    if (isNew && empty == Empty::Refused) return makeProblem(ProblemCode::P1007, at);
    if (isNew) createTables(database);
    if (auto problem = parts->check()) return *problem;
    parts->readAll();
    database.setNoBudget();
    if (parts->load.program.empty() && empty == Empty::Refused)
      return makeProblem(ProblemCode::P1007, at);
    return MemoryCard(std::move(parts));
  });
}

// SQLite plays a journal back when it opens the database. What would come out is looked at
// elsewhere first.
std::optional<Problem> MemoryCard::whyNotTheCopy(const std::string& file, const Position& at,
                                                 Empty empty) {
  const TemporaryFolder copy;
  if (copy.path().empty())
    return makeProblem(ProblemCode::P1001, at, "no folder for temporary files was found");
  std::error_code error;
  for (const char* part : {"", "-journal", "-wal"})
    if (fs::exists(file + part))
      fs::copy_file(file + part, copy.path() / (std::string("card.sqlite") + part), error);
  if (error) return makeProblem(ProblemCode::P1001, at, error.message());
  const auto card = openFile((copy.path() / "card.sqlite").string(), at, empty);
  return card ? std::nullopt : std::optional<Problem>(card.error());
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
    p.beginWriting();
    Transaction transaction(p.database);
    const Download done = writeLoadMemory(p.database, wanted);
    if (done.anotherCpu) p.clear();
    for (const auto* blocks : {&done.loaded, &done.deleted})
      for (const BlockId id : *blocks)
        if (id.kind == BlockKind::DB)
          for (const char* kind : {"DB", "made DB"}) p.pages->remove({kind, id.number});
    if (done.changed()) {
      p.contents->loadMemoryChanged();
      p.contents->write(p.pages->known());
    }
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
    p.beginWriting();
    Transaction transaction(p.database);
    p.put(data);
    transaction.commit();
    return true;
  });
  if (saved) return std::nullopt;
  return saved.error();
}

}  // namespace merker::store
