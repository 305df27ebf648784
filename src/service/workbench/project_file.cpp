#include "workbench/project_file.h"

#include "project/files.h"

namespace merker::workbench {

std::string pathOf(const Fields& fields, std::string_view ending) {
  const std::string path = fields.text("path");
  if (fields.good() && !project::hasExtension(path, ending))
    fields.add(makeProblem(ProblemCode::P1305, nowhere(), "path",
                           fmt::format("the path of a file that ends in {}", ending)));
  return path;
}

std::optional<Problem> putFile(const ProjectFolder& folder, const std::string& path,
                               std::string_view bytes, bool replace) {
  auto problem = folder.create(path, bytes);
  if (problem && problem->code == ProblemCode::P1312 && replace)
    problem = folder.write(path, bytes, std::nullopt);
  return problem;
}

}  // namespace merker::workbench
