#include "compilation/build.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "block/memory.h"
#include "compilation/existence.h"
#include "compilation/library_blocks.h"
#include "compilation/machine_code.h"
#include "compilation/network.h"
#include "compilation/stations.h"
#include "compilation/system_block_calls.h"
#include "control/memory.h"
#include "control/reference.h"
#include "nc/datum.h"
#include "step5/compiler.h"
#include "step5/variable.h"
#include "system/library.h"

namespace merker::compilation {
namespace {

// A CPU that nobody knows has no limits.
const CpuModel& modelOf(const project::Project& project) {
  return project.modelKnown ? *project.model : *findCpuModel("generic-4");
}

step7::CompileOptions options(const Build& build) {
  step7::CompileOptions options;
  options.stop = build.project.problems.stop();
  options.model = &modelOf(build.project);
  options.library = build.library.get();
  options.symbols = &build.project.symbols;
  return options;
}

}  // namespace

FileLookup Build::files() const {
  return [this](const std::string& name) {
    const source::SourceFile* own = project.file(name);
    return own == nullptr && partner ? partner->project.file(name) : own;
  };
}

namespace {

// Whether there is such a data block shows when it is looked at: programs make some (E DB).
Result<address::Reference> listingOperand(std::string_view text, const Position& at,
                                          const source::SymbolTable& symbols) {
  if (auto problem = step5::checkRange(text, &symbols, at)) return *problem;
  if (const auto variable = step5::parseVariable(text, &symbols)) return *variable;
  if (const auto datum = cnc::datumReference(text)) return *datum;
  if (nc::namesDatum(text)) return makeProblem(ProblemCode::P1154, at, text, nc::knownData(text));
  const std::string symbol = step5::symbolName(text);
  if (symbol.empty()) return makeProblem(ProblemCode::P1104, at, text);
  return makeProblem(symbols.find(symbol) ? ProblemCode::P0904 : ProblemCode::P0303, at, symbol);
}

// The symbols of the partner are its own.
simulator::Resolver listingResolver(const Build& build) {
  const auto operands = [&build](std::string_view text,
                                 const Position& at) -> Result<address::Reference> {
    if (!equalsIgnoreCase(text.substr(0, kPartner.size()), kPartner))
      return listingOperand(text, at, build.project.symbols);
    if (!build.partner) return makeProblem(ProblemCode::P1155, at, text);
    auto reference =
        listingOperand(trim(text.substr(kPartner.size())), at, build.partner->project.symbols);
    if (!reference) return reference;
    reference->partner = true;
    reference->text = text;
    return reference;
  };
  return {operands, cnc::parseConstant, true};
}

}  // namespace

monitor::ProgramCode Build::code() const {
  if (isListing()) return listings;
  return *program;
}

namespace {

simulator::Resolver programOperands(const Build& build) {
  return [&build](std::string_view text, const Position& at) {
    return step7::resolve(text, *build.program, options(build), at);
  };
}

simulator::Resolver existingOperands(const Build& build) {
  const auto existence = std::make_shared<const Existence>(build.station());
  return [existence, all = programOperands(build)](
             std::string_view text, const Position& at) -> Result<address::Reference> {
    Result<address::Reference> reference = all(text, at);
    if (!reference) return reference;
    const auto problem = existence->problem(reference.value(), at);
    return problem ? Result<address::Reference>(*problem) : reference;
  };
}

}  // namespace

simulator::Resolver Build::operands() const {
  if (isListing()) return listingResolver(*this);
  const simulator::Resolver own = programOperands(*this);
  return partner ? withStation(*this, own, partner->operands()) : own;
}

simulator::Resolver Build::resolver() const {
  if (isListing()) return listingResolver(*this);
  const simulator::Resolver own = existingOperands(*this);
  return partner ? withStation(*this, own, partner->resolver()) : own;
}

station::Station Build::station(bool coverage) const { return station(project.plants, coverage); }

station::Station Build::station(const plant::Configuration& plants, bool coverage) const {
  station::Options options;
  options.model = project.model;
  options.parameters = project.parameters;
  options.hardware = project.hardware;
  options.plants = plants;
  options.program = program;
  options.startOfClock = project.startOfClock;
  options.communication = project.communication;
  options.libraries = project.libraries;
  options.coverage = coverage;
  return station::Station(std::move(options));
}

cnc::Options Build::controlOptions() const {
  cnc::Options options = *project.control;
  options.plc.program = listings;
  return options;
}

std::unique_ptr<controller::Controller> Build::controller(bool coverage) const {
  return controller(project.plants, coverage);
}

std::unique_ptr<controller::Controller> Build::controller(const plant::Configuration& plants,
                                                          bool coverage) const {
  if (isListing()) return control(coverage);
  auto result = std::make_unique<station::Station>(station(plants, coverage));
  if (partner) result->couple(std::make_unique<station::Station>(partner->station()));
  return result;
}

std::unique_ptr<cnc::Cnc> Build::control(bool coverage) const {
  cnc::Options options = controlOptions();
  options.plc.coverage = coverage;
  auto result = std::make_unique<cnc::Cnc>(std::move(options));
  if (partner) {
    const nc::Side side = project.control->coupling->side;
    result->couple(std::make_unique<cnc::Cnc>(partner->controlOptions()), side);
  }
  return result;
}

namespace {

Position beginning(const mc5::Block& block) {
  return block.lines.empty()
             ? Position{block.file}
             : Position{block.file, block.lines.front().line, block.lines.front().column};
}

// Blocks that find no room are missing when the program runs (S5-SCHED-13, S5-DB-16).
void requireRoom(Build& build) {
  if (!build.ok()) return;
  for (const cnc::NoRoom& row : cnc::memoryUse(build.controlOptions()).missing) {
    const bool data = row.block.type == mc5::BlockType::Db;
    build.problems.add(ProblemCode::P1144, beginning(build.listings.at(row.block)),
                       sinumerik::toString(row.block), row.words, row.segment.size,
                       data ? "user data" : "user program", row.segment.size - row.segment.used);
  }
}

// FB 11 makes data blocks when the program runs.
bool makesDataBlocks(const mc5::Program& program) {
  return std::any_of(program.begin(), program.end(), [](const auto& entry) {
    const auto& words = entry.second.words;
    return std::any_of(words.begin(), words.end(), [](std::uint16_t word) {
      return word == 0x3D0B || word == 0x1D0B;  // SPA FB 11, SPB FB 11
    });
  });
}

// The bits of user alarms and messages that merker.toml names are words of the program (OP-55).
void requireBits(Build& build, std::string_view name, const Position& at,
                 const std::optional<sinumerik::BitField>& field) {
  constexpr std::size_t kWords = 4;  // 64 bits
  if (!field || field->db == 0) return;
  const auto block = build.listings.find({mc5::BlockType::Db, field->db});
  const bool there =
      block != build.listings.end() && field->first + kWords <= block->second.words.size();
  if (!there)
    build.problems.add(ProblemCode::P1153, at, name,
                       fmt::format("DB {}.DW {} (64 bits in 4 words)", field->db, field->first));
}

void requireBits(Build& build) {
  const cnc::Options& options = *build.project.control;
  if (!build.ok() || makesDataBlocks(build.listings)) return;
  requireBits(build, "alarms", options.alarmsNamed, options.plc.userAlarms.alarms);
  requireBits(build, "messages", options.messagesNamed, options.plc.userAlarms.messages);
}

void buildListings(Build& result, bool checks) {
  result.library = std::make_shared<const block::Program>();
  step5::Compilation compilation = step5::compile(
      result.project.sources, checks, result.project.problems.stop(), &result.project.symbols);
  result.problems.append(compilation.problems);
  result.listings = std::move(compilation.program);
  if (result.problems.cancelled()) return;
  requireRoom(result);
  requireBits(result);
}

void buildProgram(Build& result, bool checks) {
  result.library = std::make_shared<const block::Program>(
      system::library(modelOf(result.project), result.project.libraries));
  step7::CompileOptions compileOptions = options(result);
  compileOptions.checks = checks;
  compileOptions.mnemonics = result.project.mnemonics;
  const block::Program callable = withMachineCode(*result.library, result.project.machineCode);
  compileOptions.library = &callable;
  step7::Compilation compilation = step7::compile(result.project.sources, compileOptions);
  result.problems.append(compilation.problems);
  addMachineCode(result.project.machineCode, compilation.program, result.problems);
  preferLibraryBlocks(*result.library, compilation.program, result.problems);
  result.program = std::make_shared<const block::Program>(std::move(compilation.program));
  if (result.problems.cancelled()) return;
  project::checkAddresses(result.project, *result.program, result.problems);
  noteSystemBlockCalls(*result.program, result.problems);
}

// Half a program is none, and its problems are not those of the sources.
void cancel(Build& build) {
  build.program = std::make_shared<const block::Program>();
  build.listings.clear();
  build.problems = Problems();
  build.problems.add(ProblemCode::P0713, Position{build.project.path});
}

// The other control of [coupling]. It has one partner, this one, whatever its own project says.
void addPartner(Build& build) {
  const auto& coupling = build.project.control->coupling;
  if (!coupling) return;
  const auto folder = std::filesystem::path(build.project.folder) / coupling->partner;
  project::Project other =
      project::load(folder.lexically_normal().string(), "", {}, build.project.problems.stop());
  if (!other.unreadable && !other.control) {
    build.problems.add(ProblemCode::P0704, coupling->named, "partner",
                       "the project folder of a SINUMERIK");
    return;
  }
  if (other.control) other.control->coupling.reset();
  if (other.unreadable) {
    build.problems.append(other.problems);
    return;
  }
  auto partner = std::make_shared<Build>();
  partner->project = std::move(other);
  partner->program = std::make_shared<const block::Program>();
  partner->problems = partner->project.problems;
  buildListings(*partner, false);
  build.problems.append(partner->problems);
  build.partner = std::move(partner);
}

}  // namespace

Build build(project::Project project, bool checks) {
  Build result;
  result.project = std::move(project);
  result.program = std::make_shared<const block::Program>();
  result.problems = result.project.problems;
  if (result.project.network) {
    result.library = result.program;
    result.problems.add(needsOneStation(result.project));
  } else if (result.project.control) {
    buildListings(result, checks);
    addPartner(result);
  } else {
    buildProgram(result, checks);
    addStation(result);
  }
  if (result.problems.cancelled()) cancel(result);
  result.problems.tellRest(Position{result.project.path});
  return result;
}

void requireOb1(Build& build) {
  if (build.ok() && !build.isListing() && !build.program->contains({BlockKind::OB, 1}))
    build.problems.add(ProblemCode::P0710, Position{build.project.path});
}

void noteMissingOb1(Build& build) {
  if (build.ok() && !build.isListing() && !build.program->contains({BlockKind::OB, 1}))
    build.problems.add(ProblemCode::P0712, Position{build.project.path});
}

void requireWorkMemory(Build& build) {
  const std::size_t needed = block::workMemory(*build.program);
  const CpuModel& model = *build.project.model;
  if (build.ok() && needed > model.workMemory)
    build.problems.add(ProblemCode::P1010, Position{build.project.path}, needed, model.workMemory,
                       model.name);
}

}  // namespace merker::compilation
