// The file that a URI of a description means. A '%' is ambiguous: many tools write paths into URIs unescaped, so the literal name is
// tried before the decoded one. Both have to pass the checks of uri_text.h and uri_checks.h first, and the file those of the roots.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>

#include "base/roots.h"
#include "base/uri_text.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/uri_checks.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr int kMostLevels = 4;  // folders above the description that may hold a file that its URI places elsewhere
constexpr std::string_view kPackageScheme = "package://", kModelScheme = "model://", kFileScheme = "file://", kShortFileScheme = "file:/";

bool startsWith(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

std::string withoutLeadingSlashes(const std::string& text) {
  return text.substr(std::min(text.find_first_not_of('/'), text.size()));
}

struct PackageUri {
  std::string package, rest;
};

std::optional<PackageUri> packageUri(const std::string& uri) {
  const std::string_view scheme = startsWith(uri, kModelScheme) ? kModelScheme : kPackageScheme;
  if (!startsWith(uri, scheme)) return std::nullopt;
  const std::string path = withoutLeadingSlashes(uri.substr(scheme.size()));
  const std::size_t slash = std::min(path.find('/'), path.size());
  return PackageUri{path.substr(0, slash), withoutLeadingSlashes(path.substr(slash))};
}

// The path of a file: URI, with or without a host (RFC 8089), which may be "localhost". "file://a.stl" is relative: that is what its author
// meant.
std::string filePath(const std::string& uri) {
  if (!startsWith(uri, kFileScheme)) return uri.substr(kShortFileScheme.size() - 1);
  const std::string rest = uri.substr(kFileScheme.size());
  return startsWith(rest, "localhost/") ? rest.substr(rest.find('/')) : rest;
}

// nullopt for an unknown package.
std::optional<fs::path> pathOf(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  if (const auto in_package = packageUri(uri)) {
    const std::optional<std::string> folder = find_package.knownPackage(in_package->package);
    return folder ? std::optional(fs::path(*folder) / in_package->rest) : std::nullopt;
  }
  const bool is_file = startsWith(uri, kShortFileScheme);
  if (!is_file && uri.find("://") != std::string::npos) {
    throw Error(ErrorCode::kFileNotFound, "'" + uri + "' has a scheme that is not supported; use package://, model://, file:// or a path");
  }
  return fs::path(base).parent_path() / (is_file ? filePath(uri) : uri);  // an absolute path replaces what stands before it
}

// Also what is no regular file: whoever reads it says so.
bool isNoFolder(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

// Without ".." where that names the same file: behind a symbolic link it may name another. Folders before a ".." need not exist.
std::optional<std::string> existingFile(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  std::error_code error;
  if (isNoFolder(path) && !fs::equivalent(path, normal, error)) return path.string();
  return isNoFolder(normal) ? std::optional(normal.string()) : std::nullopt;
}

std::optional<std::string> nearbyFile(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  const auto in_package = packageUri(uri);
  return in_package ? find_package.fileNearby(in_package->package, in_package->rest, base) : std::nullopt;
}

// The first file that one of the texts means; empty if there is none.
std::string fileOf(const std::vector<std::string>& texts, const std::string& base, const PackageFinder& find_package) {
  for (const std::string& text : texts) {
    const std::optional<fs::path> path = pathOf(text, base, find_package);
    if (const auto file = path ? existingFile(*path) : std::nullopt) return *file;
  }
  for (const std::string& text : texts) {
    if (const auto file = nearbyFile(text, base, find_package)) return *file;
  }
  return "";
}

// The host that a file:// URI names; empty for none. "file://meshes/a.stl" may name one, or a folder: a file of that folder comes first.
std::string hostOf(const std::string& uri) {
  if (!startsWith(uri, kFileScheme)) return "";
  const std::string rest = filePath(uri), name = rest.substr(0, rest.find('/'));
  return name.size() == rest.size() || name == "." || name == ".." ? "" : name;
}

// ", nor does the folder 'D'" for the first folder of a missing file's path that is missing too; empty: its folder exists, or may not be
// looked for.
std::string missingFolder(const fs::path& file) try {
  std::error_code error;
  fs::path missing;
  for (fs::path folder = file.parent_path(); !fs::exists(folder, error) && folder.has_relative_path(); folder = folder.parent_path())
    missing = folder;
  if (missing.empty()) return "";
  checkRead(missing.parent_path().string());
  return ", nor does the folder '" + missing.string() + "'";
} catch (const Error&) {
  return "";
}

// Of folders that may not be read nothing is told.
bool isKnownFolder(const std::string& path) try {
  std::error_code error;
  if (!fs::is_directory(path, error)) return false;
  checkRead(path);
  return true;
} catch (const Error&) {
  return false;
}

// A file that ends like the missing one, with its folder, below a folder that holds the description, as a path from there: what an
// absolute path of another machine most likely means.
std::optional<std::string> besideDescription(const fs::path& missing, const std::string& base) try {
  if (base.empty()) return std::nullopt;
  const fs::path start = fs::absolute(base).lexically_normal().parent_path();
  fs::path above = start;
  for (int levels = 0; levels < kMostLevels && above.has_relative_path(); ++levels, above = above.parent_path()) {
    fs::path end = missing.relative_path();
    while (end.has_parent_path()) {
      if (const auto file = existingFile(above / end)) {
        checkRead(*file);
        return fs::path(*file).lexically_relative(start).string();
      }
      end = end.lexically_relative(*end.begin());
    }
  }
  return std::nullopt;
} catch (const Error&) {
  return std::nullopt;
}

// What to do about a URI of a form that means nothing here.
std::string remedyFor(const std::string& uri) {
  if (uri.find('\\') != std::string::npos) return "; folders are separated by '/' here, and there are no drives";
  if (startsWith(uri, "~")) return "; '~' is not replaced by your home folder: give the whole path";
  if (!packageUri(uri) && (startsWith(uri, "package:") || startsWith(uri, "model:"))) return "; a package's URI is package://NAME/PATH";
  return "; check the URI or the location of the file";
}

[[noreturn]] void throwMissing(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  const std::optional<fs::path> path = pathOf(percentDecoded(uri), base, find_package);
  const std::string remedy = "; rename it, or correct the case of letters in the URI";
  if (!path) {
    const auto in_package = packageUri(percentDecoded(uri));
    const std::string package = in_package->package;
    if (const auto other = find_package.nearbyInOtherCase(package, in_package->rest, base))
      throw Error(ErrorCode::kFileNotFound, "'" + uri + "' was not found, but '" + *other + "' was" + remedy);
    if (const std::string folder = find_package.standIn(package); !folder.empty())
      throw Error(ErrorCode::kFileNotFound, "'" + uri + "' does not exist in '" + folder + "', which is used in place of package '" +
                                                package + "': correct the URI, or say where the package is with --package-path " + package +
                                                "=DIR");
    // Without the URI: links that lack the same package then fail for the same reason, which is said once.
    throw Error(ErrorCode::kPackageNotFound, "package '" + package + "' was not found: install it and source its workspace, or say " +
                                                 "where it is with --package-path " + package + "=DIR");
  }
  const bool has_no_place = base.empty() && isRelativeUri(uri);
  const std::string file = fs::absolute(*path).lexically_normal().string(), host = hostOf(uri);
  if (!host.empty())
    throw Error(ErrorCode::kFileNotFound, "'" + uri + "' names the host '" + host + "', and '" + file +
                                              "' does not exist; files are read from this machine alone: give file:///PATH");
  if (const auto other = find_package.inOtherCase(file))
    throw Error(ErrorCode::kFileNotFound,
                "'" + uri + "' resolves to '" + file + "', which does not exist, but '" + *other + "' does" + remedy);
  if (isKnownFolder(file))
    throw Error(ErrorCode::kFileNotFound,
                "'" + uri + "'" + (file == uri ? "" : " resolves to '" + file + "', which") + " is a folder; give a file in it");
  const std::string nor = missingFolder(file);
  const auto beside = packageOf(uri) ? std::nullopt : besideDescription(file, base);
  if (beside)
    throw Error(ErrorCode::kFileNotFound, "'" + uri + "' " + (file == uri ? "" : "resolves to '" + file + "', which ") + "does not exist" +
                                              nor + ", but '" + *beside +
                                              "' does, from the description's folder; give that path, or a package:// URI");
  if (file == uri) throw Error(ErrorCode::kFileNotFound, "'" + uri + "' does not exist" + nor + "; check the path");
  throw Error(ErrorCode::kFileNotFound,
              "'" + uri + "' resolves to '" + file + "', which does not exist" + nor +
                  (has_no_place ? "; it is relative, and the description came without a file name that it could be relative to "
                                  "(base of a request to the node, or its parameter ~base)"
                                : remedyFor(uri)));
}

}  // namespace

std::optional<std::string> packageOf(const std::string& uri) {
  const auto in_package = packageUri(percentDecoded(uri));
  return in_package ? std::optional(in_package->package) : std::nullopt;
}

bool isRelativeUri(const std::string& uri) {
  if (startsWith(uri, kShortFileScheme)) return fs::path(filePath(uri)).is_relative();
  return uri.find("://") == std::string::npos && fs::path(uri).is_relative();
}

std::string fileUri(const std::string& path) {
  const std::string kept = "/-._~!$&'()*+,;=:@";
  std::string uri(kFileScheme);
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    char escape[4];
    std::snprintf(escape, sizeof escape, "%%%02X", byte);
    uri += byte >= 0x80 || std::isalnum(byte) || kept.find(c) != std::string::npos ? std::string(1, c) : escape;
  }
  return uri;
}

std::string resolveUri(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  if (uri.empty()) throw Error(ErrorCode::kFileNotFound, "a mesh has an empty file name; give its <mesh> a filename");
  checkCharacters(uri);
  const std::string decoded = percentDecoded(uri);
  if (const auto package = packageOf(uri)) checkPackageName(uri, *package);
  for (const std::string& text : {uri, decoded}) {
    if (const auto in_package = packageUri(text)) checkStaysWithin(uri, in_package->package, in_package->rest);
  }
  const std::string file = fileOf({uri, decoded}, base, find_package);
  if (file.empty()) throwMissing(uri, base, find_package);
  checkRead(file);
  return file;
}

}  // namespace collision_hulls
