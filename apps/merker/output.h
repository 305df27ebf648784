// Problems and values as the user reads them.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "address/reference.h"
#include "compilation/build.h"
#include "plc/controller.h"
#include "source/source_file.h"

namespace merker::app {

using compilation::FileLookup;

// All problems on standard error, in the order of their places.
void printProblems(Problems problems, const FileLookup& files);
// A list of objects with file, line, column, length, severity, code and message.
nlohmann::json toJson(Problems problems);
// The value now: a number, a truth value, or a text for DATE_AND_TIME and STRING; null if the
// operand does not exist.
nlohmann::json toJson(const address::Reference& reference, const controller::Controller& plc);
// The document on standard output, indented; text that is no UTF-8 does not stop it.
void print(const nlohmann::json& document);

}  // namespace merker::app
