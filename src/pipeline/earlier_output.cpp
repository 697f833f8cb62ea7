// A second run on the result of a first one, for other links, keeps some <collision> elements whose hulls lie in the first output. The
// new output must hold these hulls itself: it may replace the first, and nobody wants a package that needs its predecessor.
#include "pipeline/earlier_output.h"

#include "base/read_file.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "report/earlier_report.h"
#include "robot/package_crawl.h"
#include "storage/cache_folder.h"
#include "storage/names.h"
#include "storage/replace_folder.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

constexpr int kMostParts = 8;                                  // of a path below an output
constexpr std::uintmax_t kMostKept = std::uintmax_t{1} << 30;  // [bytes] of all kept hulls: they are in memory until they are written

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
  MeshFiles(const RobotDescription& robot, const std::string& output, const PackageFinder& find_package, const RunControl& control)
      : base_(robot.path), folder_(replacedFolder(output)), own_(earlierOutput(folder_, control)), finders_{find_package} {
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
  explicit EarlierOutputs(const RunControl& control) : control_(control) {}

  /// That output's folder; nullopt if no earlier output holds the file.
  std::optional<fs::path> around(const fs::path& file) {
    for (fs::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
      const auto [known, is_new] = outputs_.try_emplace(folder);
      if (is_new) known->second = earlierOutput(folder, control_);
      if (known->second && known->second->files.count(file.lexically_relative(folder))) return folder;
    }
    return std::nullopt;
  }

 private:
  const RunControl& control_;
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

/// Reads kept files, as long as they do not fill the memory: a file with holes is large, though hardly any of it is on the disk.
class KeptFiles {
 public:
  explicit KeptFiles(const RunControl& control) : control_(control) {}

  std::string read(const std::string& file) {
    const OpenFile open(file);
    open.expectAllowed();
    const std::string kind = "hull that the description keeps";
    open.expectRegular(kind);
    bytes_ += static_cast<std::uintmax_t>(open.status().st_size);
    if (bytes_ > kMostKept)
      throw Error(ErrorCode::kTooLarge, "the hulls of earlier runs that the description keeps have " + std::to_string(bytes_) +
                                            " bytes up to '" + file + "', above the limit of " + std::to_string(kMostKept) +
                                            " in all; decompose their links too, or give smaller ones");
    return open.content(kind, MeshLimits().max_bytes, control_);
  }

 private:
  const RunControl& control_;
  std::uintmax_t bytes_ = 0;  // of all so far
};

bool liesIn(const fs::path& file, const fs::path& folder) {
  return *file.lexically_relative(folder).begin() != "..";
}

[[noreturn]] void refuseLosing(const std::string& file, const std::string& use, const std::string& output,
                               const std::string& other_remedy = "") {
  throw Error(ErrorCode::kUnwritableOutput, "output '" + output + "' would be replaced, and with it '" + file + "', " + use + "; " +
                                                other_remedy + "choose another output");
}

}  // namespace

KeptHulls keptHulls(const RobotDescription& robot, const std::set<std::string>& replaced, const std::vector<std::string>& taken,
                    const std::string& output, const PackageFinder& find_package, const RunControl& control) {
  KeptHulls kept;
  const MeshFiles files(robot, output, find_package, control);
  EarlierOutputs outputs(control);
  Places places(taken);
  KeptFiles reader(control);
  for (const LinkDescription& link : robot.links) {
    if (replaced.count(link.name)) continue;
    for (const GeometryElement& collision : link.collisions) {
      control.check();
      if (!isUsableMesh(collision) || kept.places.count(collision.uri)) continue;
      const auto file = files.find(collision.uri);
      const auto folder = file ? outputs.around(*file) : std::nullopt;
      if (!folder) continue;
      const std::string place = places.of(*file, file->lexically_relative(*folder));
      kept.places[collision.uri] = place;
      if (!kept.contents.count(place)) kept.contents[place] = reader.read(file->string());
    }
  }
  return kept;
}

std::string outputWithOneOf(const std::set<std::string>& uris, const RobotDescription& robot, const std::string& output,
                            const PackageFinder& find_package, const RunControl& control) {
  const MeshFiles files(robot, output, find_package, control);
  EarlierOutputs outputs(control);
  for (const std::string& uri : uris) {
    control.check();
    const auto file = files.find(uri);
    if (const auto folder = file ? outputs.around(*file) : std::nullopt) return folder->string();
  }
  return "";
}

void refuseLosingOriginals(const RobotDescription& robot, const std::vector<MeshUse>& uses, const std::string& output,
                           const PackageFinder& find_package, const RunControl& control) {
  const fs::path folder = replacedFolder(output);
  std::error_code error;
  if (!fs::exists(folder, error)) return;
  const MeshFiles files(robot, output, find_package, control);
  const auto refuse = [&](const GeometryElement& element, const std::string& use, const std::string& other_remedy = "") {
    control.check();
    const auto file = isUsableMesh(element) ? files.find(element.uri) : std::nullopt;
    if (file && liesIn(*file, folder)) refuseLosing(element.uri, use, output, other_remedy);
  };
  for (const LinkDescription& link : robot.links)
    for (const GeometryElement& visual : link.visuals) refuse(visual, "which a <visual> of link '" + link.name + "' uses");
  for (const MeshUse& use : uses)
    if (use.options.action == Action::kDecompose)
      refuse(use.source, "which link '" + use.link + "' would be decomposed from", "decompose the description that it was made from, or ");
}

void refuseLosingCache(const Options& options, const std::string& output) {
  if (!options.cache || cacheFolder().empty()) return;
  std::error_code error;
  const fs::path cache = fs::weakly_canonical(fs::absolute(cacheFolder()), error);
  if (error || !liesIn(cache, replacedFolder(output))) return;
  throw Error(ErrorCode::kUnwritableOutput, "the cache '" + cache.string() + "' lies in output '" + output +
                                                "', which is replaced as a whole; set COLLISION_HULLS_CACHE to a folder outside of it, "
                                                "turn the cache off (--no-cache), or choose another output");
}

void refuseLosingInput(const std::string& input, const std::string& output) {
  std::error_code error;
  const fs::path folder = fs::canonical(fs::absolute(input).parent_path(), error), file = folder / fs::path(input).filename();
  if (!error && liesIn(file, replacedFolder(output))) refuseLosing(input, "which is an input", output);
}

}  // namespace collision_hulls
