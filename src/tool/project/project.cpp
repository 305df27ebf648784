#include "project/project.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "project/discovery.h"
#include "project/files.h"
#include "project/machine_code.h"
#include "project/path_pattern.h"
#include "project/settings.h"

namespace merker::project {
namespace {

constexpr const char* kSettingsFile = "merker.toml";
// Where the workbench puts blocks that it fetches from the CPU and that the project has already.
constexpr std::string_view kUploads = "online/";

// The model that `cpu` names; none if it is empty or, which is a problem, unknown.
std::optional<Model> chosenModel(Project& project, const std::string& cpu) {
  if (cpu.empty()) return std::nullopt;
  const auto model = findModel(cpu);
  if (!model) project.problems.add(ProblemCode::P0705, Position{project.path}, cpu, modelNames());
  return model;
}

// Operands of symbols are those of the program's language.
void chooseLanguage(Project& project) {
  const auto language = project.control ? source::Language::Step5 : source::Language::Step7;
  project.symbols = source::SymbolTable(language);
}

void take(Project& project, const Settings& settings) {
  if (!settings.name.empty()) project.name = settings.name;
  project.model = settings.model;
  project.mnemonics = settings.mnemonics;
  project.control = settings.control;
  project.startOfClock = settings.startOfClock;
  project.parameters = settings.parameters;
  project.communication = settings.communication;
  project.libraries = settings.libraries;
  project.hardware = settings.hardware;
  project.plants = settings.plants;
  project.serial = settings.serial;
  project.stations = settings.stations;
  project.network = settings.network;
  project.addressCheck = settings.addressCheck;
  project.vertical = settings.vertical;
  project.mpiAddress = settings.mpiAddress;
  chooseLanguage(project);
}

bool has(const Problems& problems, std::initializer_list<ProblemCode> codes) {
  return std::ranges::any_of(problems.list(), [&](const Problem& problem) {
    return std::ranges::find(codes, problem.code) != codes.end();
  });
}

// What merker.toml gets wrong is no mistake of the program: modules may be missing in it, and a CPU
// that nobody knows has no limits. `given`: the CPU is that of the command line.
void forgetWrong(Project& project, bool given) {
  if (!project.problems.hasErrors()) return;
  project.addressCheck = AddressCheck::Off;
  project.modelKnown = given || !has(project.problems, {ProblemCode::P0702, ProblemCode::P0705});
}

bool isListing(const std::string& path) { return hasExtension(path, ".s5"); }

const source::SourceFile* read(Project& project, const std::string& path,
                               std::vector<source::SourceFile>& list) {
  const auto typed = project.unsaved.find(path);
  auto file = typed == project.unsaved.end()
                  ? source::readSource(path)
                  : Result<source::SourceFile>(source::SourceFile(path, typed->second));
  if (file) {
    list.push_back(std::move(file.value()));
    return &list.back();
  }
  project.unreadable |= file.error().code == ProblemCode::P0101;
  project.problems.add(file.error());
  return nullptr;
}

// Listings are for a SINUMERIK, AWL sources for a SIMATIC S7.
void readSource(Project& project, const std::string& path) {
  if (isListing(path) && !project.control)
    project.problems.add(ProblemCode::P0707, Position{path}, project.model->name,
                         sinumerikModelNames());
  else if (!isListing(path) && project.control)
    project.problems.add(ProblemCode::P0711, Position{path}, project.control->model->name);
  else if (isMachineCode(path))
    readMachineCode(project, path);
  else
    read(project, path, project.sources);
}

void readSymbolFile(Project& project, const std::string& path) {
  if (const auto* file = read(project, path, project.otherFiles))
    source::readSymbols(*file, project.symbols, project.problems);
}

// More are a mistake, or meant to keep the loading busy.
constexpr std::size_t kLongestPattern = 260, kMostPatterns = 100;
// Of the patterns of one list with all files; a hundred patterns of many stars take so many.
constexpr std::uint64_t kMostComparisons = 50'000'000;

bool possible(Project& project, const std::vector<Pattern>& patterns) {
  if (patterns.size() > kMostPatterns) {
    project.problems.add(ProblemCode::P0717, patterns[kMostPatterns].position, patterns.size(),
                         kMostPatterns);
    return false;
  }
  for (const Pattern& pattern : patterns)
    if (pattern.text.size() > kLongestPattern) {
      project.problems.add(ProblemCode::P0716, pattern.position, pattern.text.size(),
                           kLongestPattern);
      return false;
    }
  return true;
}

// Files that match the patterns, each once, in the order of the patterns.
class Choice {
 public:
  Choice(Project& project, const std::vector<std::string>& files)
      : project_(project), files_(files), taken_(files.size()) {
    for (const std::string& file : files) upper_.push_back(upper(file));
  }

  // False if the rest of the patterns is not looked at.
  bool add(const Pattern& pattern) {
    const PathPattern path(pattern.text);
    bool found = false;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (project_.problems.cancelled()) return false;
      if (comparisons_ > kMostComparisons) return tooMany(pattern);
      if (!path.matches(upper_[i], comparisons_)) continue;
      found = true;
      if (!taken_[i]) chosen.push_back(files_[i]);
      taken_[i] = true;
    }
    if (!found) project_.problems.add(ProblemCode::P0706, pattern.position, pattern.text);
    return true;
  }

  std::vector<std::string> chosen;

 private:
  bool tooMany(const Pattern& pattern) {
    project_.problems.add(ProblemCode::P0106, pattern.position, kMostComparisons,
                          "comparisons of patterns with file names");
    return false;
  }

  Project& project_;
  const std::vector<std::string>& files_;
  std::vector<std::string> upper_;
  std::vector<bool> taken_;
  std::uint64_t comparisons_ = 0;
};

std::vector<std::string> choose(Project& project, const std::vector<std::string>& files,
                                const std::vector<Pattern>& patterns) {
  if (!possible(project, patterns)) return {};
  Choice choice(project, files);
  for (const Pattern& pattern : patterns)
    if (!choice.add(pattern)) break;
  return std::move(choice.chosen);
}

template <typename Predicate>
std::vector<std::string> filter(const std::vector<std::string>& files, Predicate predicate) {
  std::vector<std::string> chosen;
  std::copy_if(files.begin(), files.end(), std::back_inserter(chosen), predicate);
  return chosen;
}

void loadFolder(Project& project, const std::string& cpu) {
  const auto* settingsFile = read(project, join(project.folder, kSettingsFile), project.otherFiles);
  const auto model = chosenModel(project, cpu);
  const Settings settings =
      settingsFile ? readSettings(*settingsFile, project.problems, model) : Settings{};
  take(project, settings);
  forgetWrong(project, model.has_value());
  if (project.network) return;
  const std::vector<std::string> files = listFiles(project.folder, &project.problems);
  const auto sources = settings.sources ? choose(project, files, *settings.sources)
                                        : filter(files, [&project](const std::string& f) {
                                            if (project.control) return isListing(f);
                                            return (hasExtension(f, ".awl") || isMachineCode(f)) &&
                                                   !f.starts_with(kUploads);
                                          });
  const auto symbols =
      settings.symbols ? choose(project, files, *settings.symbols) : filter(files, isSymbolExport);
  for (const std::string& file : symbols) readSymbolFile(project, join(project.folder, file));
  for (const std::string& file : sources)
    if (!project.problems.cancelled()) readSource(project, join(project.folder, file));
  // A merker.toml that cannot be read may name stations or sources.
  if (sources.empty() && !has(project.problems, {ProblemCode::P0702}))
    project.problems.add(ProblemCode::P0708, Position{project.path},
                         project.control ? "*.s5" : "*.awl");
}

void fail(Project& project, ProblemCode code) {
  project.unreadable = true;
  project.problems.add(code, Position{project.path}, project.path);
}

std::string baseName(const std::string& folder) {
  std::error_code error;
  const auto absolute = std::filesystem::weakly_canonical(folder, error);
  return absolute.filename().string();
}

}  // namespace

const source::SourceFile* Project::file(const std::string& wanted) const {
  for (const auto* list : {&sources, &otherFiles})
    for (const source::SourceFile& file : *list)
      if (file.name() == wanted) return &file;
  return nullptr;
}

static Project loadSources(Project project, const std::string& path,
                           const std::vector<std::string>& sources, const std::string& cpu) {
  project.path = path;
  project.folder = folderOf(path);
  project.name = stemOf(path);
  project.startOfClock = defaultStartOfClock();
  const auto model = chosenModel(project, cpu);
  if (model && model->simatic) project.model = model->simatic;
  if (model && model->sinumerik) project.control.emplace().model = model->sinumerik;
  if (!model && std::all_of(sources.begin(), sources.end(), isListing)) project.control.emplace();
  chooseLanguage(project);
  project.parameters = CpuParameters::of(*project.model);
  project.communication = CommunicationParameters::of(*project.model);
  for (const std::string& source : sources)
    for (const std::string& name : symbolsBeside(source))
      readSymbolFile(project, join(folderOf(source), name));
  for (const std::string& source : sources) readSource(project, source);
  return project;
}

Project loadSources(const std::string& path, const std::vector<std::string>& sources,
                    const std::string& cpu) {
  return loadSources(Project{}, path, sources, cpu);
}

Project loadConfiguration(const std::string& path, const std::string& text,
                          const std::string& cpu) {
  Project project;
  project.path = project.folder = path;
  project.name = baseName(path);
  project.otherFiles.emplace_back(join(path, kSettingsFile), text);
  take(project,
       readSettings(project.otherFiles.back(), project.problems, chosenModel(project, cpu)));
  return project;
}

std::string configurationText(const Project& project) {
  const source::SourceFile* file = project.file(join(project.folder, kSettingsFile));
  return file == nullptr ? std::string() : std::string(file->text());
}

Project load(const std::string& path, const std::string& cpu, const Unsaved& unsaved,
             std::stop_token stop) {
  Project project;
  project.problems = Problems(std::move(stop));
  project.path = path;
  project.unsaved = unsaved;
  if (isFile(path) && std::filesystem::path(path).filename() == kSettingsFile) {
    project.folder = folderOf(path);
  } else if (isFolder(path)) {
    project.folder = path;
    if (!isFile(join(path, kSettingsFile))) {
      fail(project, ProblemCode::P0701);
      return project;
    }
  } else if (isFile(path) && !hasExtension(path, ".awl") && !hasExtension(path, ".s5")) {
    fail(project, ProblemCode::P0709);
    return project;
  } else {
    return loadSources(std::move(project), path, {path}, cpu);
  }
  project.name = baseName(project.folder);
  loadFolder(project, cpu);
  return project;
}

}  // namespace merker::project
