// A project, loaded and compiled.
#pragma once

#include <functional>
#include <memory>

#include "control/cnc.h"
#include "mc5/block.h"
#include "monitor/code.h"
#include "project/project.h"
#include "scenario/term.h"
#include "station/station.h"
#include "step7/compiler.h"

namespace merker::compilation {

using FileLookup = std::function<const source::SourceFile*(const std::string& name)>;

struct Build {
  project::Project project;
  std::shared_ptr<const block::Program> library;  // what the CPU brings
  Problems problems;                              // of loading and compiling
  std::shared_ptr<const block::Program> program;  // of a SIMATIC S7, else empty
  mc5::Program listings;                          // of a SINUMERIK
  std::shared_ptr<const Build> partner;           // the PLC that is coupled with it, if any
  bool isListing() const { return project.control.has_value(); }
  std::size_t blocks() const { return isListing() ? listings.size() : program->size(); }
  bool ok() const { return !problems.hasErrors(); }
  monitor::ProgramCode code() const;  // of a program that compiled
  FileLookup files() const;
  // Operands by their text; whether they exist shows when they are read. The Build must outlive it.
  simulator::Resolver operands() const;
  // The same, only operands that exist in its CPU.
  simulator::Resolver resolver() const;
  station::Station station(bool coverage = false) const;  // a SIMATIC S7 only
  station::Station station(const plant::Configuration& plants, bool coverage) const;  // the same
  cnc::Options controlOptions() const;                             // a SINUMERIK only
  std::unique_ptr<cnc::Cnc> control(bool coverage = false) const;  // the same
  std::unique_ptr<controller::Controller> controller(bool coverage = false) const;
  // With these plants beside it in place of the project's: the same ones with other parameters.
  std::unique_ptr<controller::Controller> controller(const plant::Configuration& plants,
                                                     bool coverage = false) const;
};

// Ends early, with P0713 alone, when the project's loading is asked to stop (project::load).
Build build(project::Project project, bool checks);
// Adds the problem that a program without OB 1 cannot run (S7-OPEN-39).
void requireOb1(Build& build);
// The same as a warning: blocks without OB 1 may be a library.
void noteMissingOb1(Build& build);
// Adds the problem that the program needs more work memory than the CPU has (S7-CPU-02).
void requireWorkMemory(Build& build);

}  // namespace merker::compilation
