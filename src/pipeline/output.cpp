// Writes an output folder beside the old one and exchanges the two, and never replaces files that it did not write.
#include "collision_hulls/pipeline/output.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "base/counted.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision_hulls/config/config.h"
#include "collision_hulls/error.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/collision_model.h"
#include "pipeline/package/manifest.h"
#include "pipeline/run.h"
#include "report/earlier_report.h"
#include "storage/files.h"
#include "storage/names.h"
#include "storage/replace_folder.h"
#include "storage/trusted_file.h"
#include "web/report_page.h"
#include "web/three_js.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

void refuseForeign(const fs::path& folder, const RunControl& control) {
  std::error_code error;
  if (!fs::exists(folder, error)) return;
  if (!fs::is_directory(folder, error)) {
    throw Error(ErrorCode::kNotOurOutput, "'" + folder.string() + "' is not a folder; choose another output");
  }
  if (fs::is_empty(folder, error)) return;
  const std::optional<EarlierOutput> known = earlierOutput(folder, control);
  if (!known) {
    throw Error(ErrorCode::kNotOurOutput,
                "'" + folder.string() +
                    "' is not an earlier output (it has no report.json of collision_hulls) and is left alone; choose another output" +
                    (fs::exists(folder / "package.xml", error) ? "" : ", or remove it yourself"));
  }
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    control.check();
    const fs::path file = entry->path().lexically_relative(folder);
    std::error_code unknown;
    if (entry->symlink_status(unknown).type() == fs::file_type::directory || known->files.count(file) > 0) continue;
    throw Error(ErrorCode::kNotOurOutput,
                "'" + folder.string() + "' holds '" + file.string() +
                    "', which is not part of the earlier output there, and is left alone; choose another output, or "
                    "move that file away");
  }
  if (error)
    throw Error(ErrorCode::kUnwritableOutput, "the earlier output '" + folder.string() + "' cannot be looked through: " + error.message() +
                                                  "; allow it, or choose another output");
}

/// Everything but the hulls and the report.
std::map<std::string, std::string> otherFiles(const RobotResult& result, const std::string& package, const RunControl& control) {
  std::map<std::string, std::string> files = result.extra_files;
  files.insert(result.kept_files.begin(), result.kept_files.end());
  if (result.single_mesh) return files;
  files[urdfFile(result.robot_name)] = result.urdf;
  for (std::size_t i = 0; i < result.models.size(); ++i)
    files[urdfFile(result.robot_name, result.report.models[i].model)] = result.models[i].urdf;
  files["config/" + robotFileName(result.robot_name) + "_hulls.yaml"] = configText(result.report.options);
  files["package.xml"] = packageXml(package, result, control);
  files["CMakeLists.txt"] = cmakeLists(package, result);
  return files;
}

constexpr const char* kPageFile = "report.html";

/// Rows without an element, as in a report that was made by hand, are in the table alone.
PageModel pageModel(const ModelReport& report, const ModelResult& model) {
  PageModel page{report, {}, {}};
  const std::size_t count = std::min(report.links.size(), model.elements.size());
  for (std::size_t i = 0; i < count; ++i) {
    const ElementResult& element = model.elements[i];
    page.elements.push_back({element.original, element.hulls, element.pose, element.primitives, element.coarser.get()});
  }
  for (const KeptElement& kept : model.kept) page.kept.push_back({kept.element, kept.surface, kept.pose});
  return page;
}

std::string pageOf(const RobotResult& result, const RunControl& control) {
  const Report& report = result.report;
  PageContent content{result.robot_name, report, {pageModel(report, result)}, result.single_mesh, result.scene};
  for (std::size_t i = 0; i < result.models.size(); ++i) content.models.push_back(pageModel(report.models[i], result.models[i]));
  std::string page;
  withJobs(report.options.jobs, [&] { page = reportPage(content, threeJs(), control); });
  return page;
}

/// The folder that an output is written to, and the one whose place it takes, which may not exist.
struct Folders {
  fs::path next, earlier;
  mode_t mode = 0;  // permissions of new files

  /// A file that the earlier output has, byte for byte, becomes a hard link to it: nothing to write or to flush. Not one of another user's
  /// output, who could write to it later, nor one with other permissions than a new file gets.
  void write(const fs::path& name, const std::string& text) const {
    const fs::path file = next / name;
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    if (!linkTrustedFile((earlier / name).string(), text, mode, file.string())) writeText(file, text);
  }
};

/// `written`: the files so far, which other models may share.
void writeHulls(const ElementResult& element, const std::vector<std::string>& files, MeshFormat format, const Folders& folders,
                std::set<std::string>& written) {
  const std::size_t hulls = element.hulls.size() - element.primitives.size();
  const std::size_t first = files.size() - hulls;  // the OBJ of all hulls stands before a file for each
  if (first > 0) folders.write(files.front(), encodeHullsObj(element.hulls, fileName(element.link)));
  for (std::size_t m = 0; m < hulls; ++m) {
    const fs::path file = files[first + m];
    if (!written.insert(file.string()).second) continue;
    folders.write(file, encodeHull(element.hulls[m], format, file.stem().string()));
  }
}

void writeModel(const ModelResult& model, MeshFormat format, const Folders& folders, std::set<std::string>& written, ModelReport& report,
                const RunControl& control) {
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    control.check();
    Stopwatch stage;
    ElementReport& row = report.links[i];
    writeHulls(model.elements[i], row.files, format, folders, written);
    row.seconds.write = stage.lap();
  }
}

/// The output replaces the whole folder, which neither a mount point nor the current folder allows.
void refuseInUse(const fs::path& folder) {
  std::error_code none;
  const fs::path place = fs::canonical(folder, none), here = fs::current_path(none);
  if (place.empty()) return;
  const std::string advice = "; choose another output, such as a folder within it";
  if (std::mismatch(place.begin(), place.end(), here.begin(), here.end()).first == place.end())
    throw Error(ErrorCode::kUnwritableOutput,
                "output '" + folder.string() + "' would be replaced as a whole, but " +
                    (place == here ? "it is the current folder" : "the current folder '" + here.string() + "' lies in it") + advice);
  struct stat of_folder {
  }, of_parent{};
  if (stat(place.c_str(), &of_folder) == 0 && stat(place.parent_path().c_str(), &of_parent) == 0 && of_folder.st_dev != of_parent.st_dev)
    throw Error(ErrorCode::kUnwritableOutput, "output '" + folder.string() + "' is a mount point and cannot be replaced" + advice);
}

/// The hulls of the other models that the first has not.
std::vector<std::string> filesOfOthers(const Report& report) {
  std::set<std::string> of_first, of_others;
  for (const ElementReport& row : report.links) of_first.insert(row.files.begin(), row.files.end());
  for (const ModelReport& model : report.models) {
    for (const ElementReport& row : model.links) {
      for (const std::string& file : row.files)
        if (!of_first.count(file)) of_others.insert(file);
    }
  }
  return {of_others.begin(), of_others.end()};
}

/// Whether a second run may well do better.
bool lackedMeans(const ElementReport& row) {
  return row.status == Status::kFailed && (row.error == name(ErrorCode::kOutOfMemory) || row.error == name(ErrorCode::kOutOfTime));
}

/// An output with all meshes is worth more than one without those that memory or time did not suffice for.
void refuseLosingMeshes(const Report& report, const fs::path& folder, const RunControl& control) {
  if (report.options.replace_complete) return;
  std::vector<ElementReport> lacked;
  const auto add = [&](const ModelReport& model) {
    std::copy_if(model.links.begin(), model.links.end(), std::back_inserter(lacked), lackedMeans);
  };
  add(report);
  for (const ModelReport& model : report.models) add(model);
  const std::optional<EarlierOutput> earlier = lacked.empty() ? std::nullopt : earlierOutput(folder, control);
  if (!earlier || !earlier->complete) return;
  throw Error(ErrorCode::kUnwritableOutput,
              "output '" + folder.string() + "' stays as it is: it has all meshes, and this run lacked memory or time for " +
                  counted(lacked.size(), "mesh", "meshes") + ", such as '" + lacked.front().uri + "' of link '" + lacked.front().link +
                  "'; run again with fewer jobs or a larger tolerance, choose another output, or run 'decompose --replace-complete'");
}

/// URIs that name another place would lead nowhere, or to an older output's hulls.
void refuseOtherPlace(const RobotResult& result, const std::string& output) {
  const std::string place = placeOfUris(result.report.options, output);
  if (result.place.empty() || place == result.place) return;
  throw Error(ErrorCode::kBadOption, "output '" + output + "' is '" + place + "' to the description, whose URIs refer to '" + result.place +
                                         "'; give writeOutput() the folder that the decomposition was given");
}

/// The report says what the folder loses: hulls are made again, but not those of links that were not chosen, nor what only a fit to a scene
/// makes. `hulls`: the files written.
void noteLost(const fs::path& folder, const std::set<std::string>& hulls, const std::map<std::string, std::string>& files, Report& report,
              const RunControl& control) {
  const std::optional<EarlierOutput> earlier = earlierOutput(folder, control);
  if (!earlier) return;
  std::set<fs::path> folders;  // of meshes; each link has one
  for (const std::string& file : hulls) folders.insert(fs::path(file).parent_path());
  for (const auto& [file, content] : files) folders.insert(fs::path(file).parent_path());
  const auto lost = std::find_if(earlier->files.begin(), earlier->files.end(),
                                 [&](const fs::path& file) { return *file.begin() == "meshes" && folders.count(file.parent_path()) == 0; });
  if (!report.options.links.empty() && lost != earlier->files.end())
    report.notes.push_back("the earlier output in '" + folder.string() + "' had hulls of links that this run leaves out, such as '" +
                           lost->string() + "'; they are gone. To treat some links otherwise and keep the rest, " +
                           (report.options.links_place.empty() ? "use --config in place of --links" : "use 'links' in place of 'only'"));
  for (const fs::path& file : earlier->files) {
    if (file.extension() != ".srdf" || files.count(file.string()) > 0) continue;
    report.notes.push_back("the earlier output in '" + folder.string() + "' had '" + file.string() +
                           "', with pairs of links of a model that was fitted to a scene; it went with that model");
  }
}

}  // namespace

void checkOutput(const std::string& output, const RunControl& control) {
  const fs::path folder = replacedFolder(output);
  refuseInUse(folder);
  refuseForeign(folder, control);
  checkFolderOf(folder);
}

// 6. Write.
bool writeOutput(RobotResult& result, const std::string& output, const RunControl& control) {
  if (allFailed(result.report)) return false;
  Stopwatch run;
  refuseOtherPlace(result, output);
  checkOutput(output, control);
  refuseLosingMeshes(result.report, replacedFolder(output), control);
  FolderReplacement replacement(output);
  const Folders folders{replacement.folder(), replacedFolder(output), replacement.fileMode()};
  std::set<std::string> written;
  for (std::size_t model = 0; model <= result.models.size(); ++model)
    writeModel(modelOf(model, result), result.report.options.format, folders, written, reportOf(model, result.report), control);
  const std::map<std::string, std::string> others = otherFiles(result, outputPackage(result.report.options, output), control);
  result.report.files = filesOfOthers(result.report);
  for (const auto& [file, text] : others) {
    folders.write(file, text);
    result.report.files.push_back(file);
  }
  noteLost(folders.earlier, written, others, result.report, control);
  if (result.report.options.html) {
    folders.write(kPageFile, pageOf(result, control));
    result.report.files.emplace_back(kPageFile);
  }
  result.report.seconds += run.lap();
  folders.write(kReportFile, toJson(result.report, control));
  refuseForeign(replacedFolder(output), control);
  control.check();
  replacement.commit();
  return true;
}

void writeReport(const Report& report, const std::string& file, const RunControl& control) {
  writeNamedFile(file, toJson(report, control), control);
}

}  // namespace collision_hulls
