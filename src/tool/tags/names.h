// Names that another tool accepts.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace merker::tags {

// Turns `name` into one that `allowed` accepts character by character: everything else becomes "_".
// Characters above 127 stay: they are letters of names.
std::string cleaned(std::string_view name, const std::function<bool(char)>& allowed);

bool isWordCharacter(char c);  // letter, digit or underscore of ASCII

// Gives each name once: "Motor", "Motor_2". Compared without case, as the tools do.
class UniqueNames {
 public:
  std::string operator()(const std::string& name);

 private:
  std::set<std::string> taken_;
};

}  // namespace merker::tags
