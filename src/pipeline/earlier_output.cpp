// A second run on the result of a first one, for other links, keeps some <collision> elements whose hulls lie in the first output. The
// new output must hold these hulls itself: it may replace the first, and nobody wants a package that needs its predecessor.
#include "pipeline/earlier_output.h"

#include "base/read_file.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "report/earlier_report.h"
#include "robot/package_crawl.h"
#include "storage/names.h"
#include "storage/replace_folder.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr int kMostParts = 8;  // of a path below an output

bool isUsableMesh(const GeometryElement& element) {
  return element.kind == GeometryElement::Kind::kMesh && element.fault.empty();
}

/// The file in its real folder. A file may itself be a link, as in an output that git-annex holds: it keeps its name.
fs::path inRealFolder(const fs::path& file) {
  return fs::canonical(fs::absolute(file).parent_path()) / file.filename();
}

/// The files that a description means.
class MeshFiles {
 public:
  MeshFiles(const RobotDescription& robot, const std::string& output, const PackageFinder& find_package)
      : base_(robot.path), folder_(replacedFolder(output)), own_(earlierOutput(folder_)), finders_{find_package} {
    // The folder to be replaced may hold a package that nobody else knows, such as one that was made a minute ago.
    if (const auto package = packageAt(folder_)) {
      finders_.emplace_back([name = package->name, folder = folder_.string()](const std::string& wanted) {
        return wanted == name ? std::optional(folder) : std::nullopt;
      });
    }
  }

  /// The file that a URI means, in its real folder; nullopt if there is none.
  std::optional<fs::path> find(const std::string& uri) const {
    for (const PackageFinder& find_package : finders_) {
      try {
        return inRealFolder(resolveUri(uri, base_, find_package));
      } catch (const Error&) {  // then it is nothing of ours
      }
    }
    return findOwn(uri);
  }

 private:
  /// A file of the folder to be replaced, by the end of its path: the folder, or the description, may have moved since.
  std::optional<fs::path> findOwn(const std::string& uri) const {
    if (!own_ || uri.rfind("package://", 0) == 0) return std::nullopt;
    std::size_t slash = uri.size();
    for (int parts = 0; parts < kMostParts && slash > 0; ++parts) {
      slash = uri.rfind('/', slash - 1);
      if (slash == std::string::npos) break;
      const fs::path file = uri.substr(slash + 1);
      if (slash > 0 && file.has_parent_path() && own_->files.count(file)) return folder_ / file;
    }
    return std::nullopt;
  }

  std::string base_;
  fs::path folder_;                   // that is replaced
  std::optional<EarlierOutput> own_;  // the earlier output there
  std::vector<PackageFinder> finders_;
};

/// Finds the earlier output that holds a file. Remembers the folders that it has looked into.
class EarlierOutputs {
 public:
  /// The file's path within that output; nullopt if no earlier output holds it.
  std::optional<fs::path> pathWithin(const fs::path& file) {
    for (fs::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
      const auto [known, is_new] = outputs_.try_emplace(folder);
      if (is_new) known->second = earlierOutput(folder);
      const fs::path within = file.lexically_relative(folder);
      if (known->second && known->second->files.count(within)) return within;
    }
    return std::nullopt;
  }

 private:
  std::map<fs::path, std::optional<EarlierOutput>> outputs_;
};

/// Gives every kept file a path in the new output: the one that it had, if that is free.
class Places {
 public:
  explicit Places(const std::vector<std::string>& taken) {
    for (const std::string& file : taken) names_.take(fs::path(file).replace_extension().string());
  }

  std::string of(const fs::path& file, const fs::path& within) {
    std::string& place = places_[file];
    if (!place.empty()) return place;
    const fs::path wanted = *within.begin() == "meshes" ? within : "meshes" / within;
    return place = names_.take(fs::path(wanted).replace_extension().string()) + wanted.extension().string();
  }

 private:
  UniqueNames names_;
  std::map<fs::path, std::string> places_;
};

bool liesIn(const fs::path& file, const fs::path& folder) {
  return *file.lexically_relative(folder).begin() != "..";
}

[[noreturn]] void refuseLosing(const std::string& file, const std::string& use, const std::string& output) {
  throw Error(ErrorCode::kUnwritableOutput,
              "output '" + output + "' would be replaced, and with it '" + file + "', " + use + "; choose another output");
}

}  // namespace

KeptHulls keptHulls(const RobotDescription& robot, const std::set<std::string>& replaced, const std::vector<std::string>& taken,
                    const std::string& output, const PackageFinder& find_package) {
  KeptHulls kept;
  const MeshFiles files(robot, output, find_package);
  EarlierOutputs outputs;
  Places places(taken);
  for (const LinkDescription& link : robot.links) {
    if (replaced.count(link.name)) continue;
    for (const GeometryElement& collision : link.collisions) {
      if (!isUsableMesh(collision) || kept.places.count(collision.uri)) continue;
      const auto file = files.find(collision.uri);
      const auto within = file ? outputs.pathWithin(*file) : std::nullopt;
      if (!within) continue;
      const std::string place = places.of(*file, *within);
      kept.places[collision.uri] = place;
      kept.contents[place] = readFile(file->string(), "hull that the description keeps", MeshLimits().max_bytes);
    }
  }
  return kept;
}

void refuseLosingVisuals(const RobotDescription& robot, const std::string& output, const PackageFinder& find_package) {
  const fs::path folder = replacedFolder(output);
  std::error_code error;
  if (!fs::exists(folder, error)) return;
  const MeshFiles files(robot, output, find_package);
  for (const LinkDescription& link : robot.links) {
    for (const GeometryElement& visual : link.visuals) {
      const auto file = isUsableMesh(visual) ? files.find(visual.uri) : std::nullopt;
      if (file && liesIn(*file, folder)) refuseLosing(visual.uri, "which a <visual> of link '" + link.name + "' uses", output);
    }
  }
}

void refuseLosingInput(const std::string& input, const std::string& output) {
  std::error_code error;
  const fs::path folder = fs::canonical(fs::absolute(input).parent_path(), error), file = folder / fs::path(input).filename();
  if (!error && liesIn(file, replacedFolder(output))) refuseLosing(input, "which is an input", output);
}

}  // namespace collision_hulls
