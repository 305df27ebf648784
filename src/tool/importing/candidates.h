// The programs in a source, of whatever family, and what tells them apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "importing/merker_project.h"
#include "importing/step5_material.h"
#include "s7p/catalogue.h"

namespace merker::importing {

// A program of STEP 7, of STEP 5 or of Merker itself. It refers to the lists that it comes from.
struct Candidate {
  std::string name;   // as the manager calls it
  std::string label;  // of all programs different: the name, or the path in the source with it
  const s7p::Project* project = nullptr;
  const s7p::Program* program = nullptr;
  const Step5Program* step5 = nullptr;
  const MerkerProject* merker = nullptr;
};

// Each becomes a project. Programs of STEP 5 that lie in a project of Merker are a part of that.
std::vector<Candidate> candidates(const std::vector<s7p::Project>& projects,
                                  const std::vector<Step5Program>& step5,
                                  const std::vector<MerkerProject>& merker);

std::vector<std::string> labels(const std::vector<Candidate>& list);

// The one of this label, or of this name if there is one only; "" for all.
std::vector<Candidate> chosenOf(const std::vector<Candidate>& list, std::string_view wanted);

}  // namespace merker::importing
