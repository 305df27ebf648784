// What the engine has of the program, and its part in running it (engine.h).
#pragma once

#include "softplc/engine.h"
#include "softplc/options.h"
#include "softplc/probes.h"
#include "softplc/recorder.h"

namespace merker::sinumerik {

class CompiledCode {
 public:
  // What recorder and probes look at stays with the processor.
  CompiledCode(const Options& options, Machine& machine, const Environment& environment,
               Recorder& recorder, Probes& probes);

  void forget() { version_ = kNone; }  // what the code depends on has changed
  void translate();
  // Instructions of the running level that begin before the horizon. How many were executed; 0: the
  // next one is the processor's.
  std::uint64_t run(Instant horizon);

 private:
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};

  const Options& options_;
  Machine& machine_;
  const Environment& environment_;
  Recorder& recorder_;
  Probes& probes_;
  std::uint64_t version_ = kNone;  // of the code that the engine has
};

}  // namespace merker::sinumerik
