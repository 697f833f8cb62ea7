// Collects meshes from files, folders and robots. A mesh that several links use is benchmarked once, at one scale; a mesh without a file
// stays in the list, so that its rows say what is missing.
#include "bench/inputs.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/pipeline/input.h"
#include "pipeline/mesh_uses.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

void addRobot(const Input& input, BenchmarkInputs& all) {
  const std::vector<MeshUse> uses = meshUses(input.robot, modelDecisions({}, input.robot));
  const auto resolve = [&](const std::string& uri) { return resolveUri(uri, input.robot.path, input.find_package); };
  auto [tasks, failed] = meshTasks(uses, resolve, MeshLimits(), RunControl());
  const auto uses_of = [](const MeshTask& task) { return task.variants.front().uses; };  // all links have the same options
  std::sort(tasks.begin(), tasks.end(), [&](const MeshTask& a, const MeshTask& b) { return uses_of(a).front() < uses_of(b).front(); });
  std::map<std::string, std::size_t> link_index;
  for (std::size_t i = 0; i < input.robot.links.size(); ++i) link_index[input.robot.links[i].name] = i;
  QuerySubject subject{input.robot.name, input.robot, {}};
  for (const MeshTask& task : tasks) {
    for (const std::size_t i : uses_of(task)) subject.parts.push_back({link_index[uses[i].link], all.meshes.size(), uses[i].source.origin});
    all.meshes.push_back({input.robot.name + "/" + fs::path(task.file).filename().string(), task.file, task.scale});
  }
  // A mesh without a file stays in the list: its rows say what is missing.
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const GeometryElement& source = uses[i].source;
    if (failed[i]) all.meshes.push_back({input.robot.name + "/" + uses[i].link, source.uri, source.scale});
  }
  if (!subject.parts.empty()) all.subjects.push_back(std::move(subject));
}

void addMesh(const std::string& name, const fs::path& file, BenchmarkInputs& all) {
  all.subjects.push_back({name, {}, {{0, all.meshes.size(), Eigen::Isometry3d::Identity()}}});
  all.meshes.push_back({name, file.string(), {1, 1, 1}});
}

void addFolder(const fs::path& folder, const fs::path& top, BenchmarkInputs& all) {
  if (fs::exists(folder / "package.xml") && !robotDescriptionsIn(folder.string()).empty()) {
    for (const std::string& description : robotDescriptionsIn(folder.string())) addRobot(openInput(description), all);
    return;
  }
  std::vector<fs::path> entries(fs::directory_iterator(folder), fs::directory_iterator{});
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    if (fs::is_directory(entry) && !fs::is_symlink(entry)) addFolder(entry, top, all);
    if (fs::is_regular_file(entry) && isMeshFile(entry)) addMesh(fs::relative(entry, top).string(), entry, all);
  }
}

void addInput(const std::string& input, BenchmarkInputs& all) {
  const std::size_t before = all.meshes.size();
  if (fs::is_directory(input)) {
    addFolder(input, input, all);
  } else {
    const Input opened = openInput(input);
    if (opened.kind == Input::Kind::kRobot) addRobot(opened, all);
    if (opened.kind == Input::Kind::kMesh) addMesh(fs::path(input).filename().string(), input, all);
  }
  if (all.meshes.size() == before)
    throw Error(ErrorCode::kFileNotFound, "input '" + input + "' contains no mesh; give mesh files, folders of them, or robots");
}

/// Appends a number to a name that is already taken.
template <typename Items>
void makeUnique(Items& items) {
  std::map<std::string, int> taken;
  for (auto& item : items) {
    const int times = ++taken[item.name];
    if (times > 1) item.name += "#" + std::to_string(times);
  }
}

}  // namespace

BenchmarkInputs benchmarkInputs(const std::vector<std::string>& inputs) {
  BenchmarkInputs all;
  for (const std::string& input : inputs) addInput(input, all);
  makeUnique(all.meshes);
  makeUnique(all.subjects);
  return all;
}

std::vector<BenchmarkMesh> benchmarkMeshes(const std::vector<std::string>& inputs) {
  return benchmarkInputs(inputs).meshes;
}

}  // namespace collision_hulls
