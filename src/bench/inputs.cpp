#include "bench/inputs.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/elements.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

bool isMesh(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::vector<std::string>& known = meshExtensions();
  return std::find(known.begin(), known.end(), extension) != known.end();
}

/// A URI without a file stays as it is: the runs on it say what is missing.
std::vector<BenchmarkMesh> robotMeshes(const Input& input) {
  std::vector<ElementResult> elements = meshElements(input.robot, {});
  const auto resolve = [&](const std::string& uri) { return resolveUri(uri, input.robot.path, input.find_package); };
  std::vector<MeshTask> tasks = meshTasks(elements, resolve);
  std::sort(tasks.begin(), tasks.end(), [](const MeshTask& a, const MeshTask& b) { return a.elements.front() < b.elements.front(); });
  std::vector<BenchmarkMesh> meshes;
  for (const MeshTask& task : tasks) {
    meshes.push_back(
        {input.robot.name + "/" + fs::path(task.file).filename().string(), task.file, elements[task.elements.front()].report.scale});
  }
  for (const ElementResult& element : elements) {
    const ElementReport& row = element.report;
    if (row.status == Status::kFailed) meshes.push_back({input.robot.name + "/" + row.link, row.uri, row.scale});
  }
  return meshes;
}

void addFolder(const fs::path& folder, const fs::path& top, std::vector<BenchmarkMesh>& meshes) {
  if (fs::exists(folder / "package.xml") && !robotDescriptionsIn(folder.string()).empty()) {
    for (const std::string& description : robotDescriptionsIn(folder.string())) {
      for (BenchmarkMesh& mesh : robotMeshes(openInput(description))) meshes.push_back(std::move(mesh));
    }
    return;
  }
  std::vector<fs::path> entries(fs::directory_iterator(folder), fs::directory_iterator{});
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    if (fs::is_directory(entry)) addFolder(entry, top, meshes);
    if (fs::is_regular_file(entry) && isMesh(entry)) meshes.push_back({fs::relative(entry, top).string(), entry.string(), {1, 1, 1}});
  }
}

std::vector<BenchmarkMesh> meshesOf(const std::string& input) {
  std::vector<BenchmarkMesh> meshes;
  if (fs::is_directory(input)) {
    addFolder(input, input, meshes);
  } else {
    const Input opened = openInput(input);
    if (opened.kind == Input::Kind::kRobot) return robotMeshes(opened);
    meshes.push_back({fs::path(input).filename().string(), input, {1, 1, 1}});
  }
  return meshes;
}

}  // namespace

std::vector<BenchmarkMesh> benchmarkMeshes(const std::vector<std::string>& inputs) {
  std::vector<BenchmarkMesh> all;
  std::map<std::string, int> taken;
  for (const std::string& input : inputs) {
    std::vector<BenchmarkMesh> meshes = meshesOf(input);
    if (meshes.empty()) throw Error(ErrorCode::kFileNotFound, "input '" + input + "' holds no mesh; give mesh files, folders or robots");
    for (BenchmarkMesh& mesh : meshes) {
      const int times = ++taken[mesh.name];
      if (times > 1) mesh.name += "#" + std::to_string(times);
      all.push_back(std::move(mesh));
    }
  }
  return all;
}

}  // namespace collision_hulls
