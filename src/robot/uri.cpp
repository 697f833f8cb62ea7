// The file that a URI of a description means. A '%' is ambiguous: many tools write paths into URIs unescaped, so the literal name is
// tried before the decoded one.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>

#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr std::string_view kPackageScheme = "package://", kFileScheme = "file://";

bool startsWith(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

std::string withoutLeadingSlashes(const std::string& text) {
  return text.substr(std::min(text.find_first_not_of('/'), text.size()));
}

// "%20" and its like become the bytes that they stand for; a '%' without two digits stays.
std::string percentDecoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size() && std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
                        std::isxdigit(static_cast<unsigned char>(text[i + 2]));
    decoded += escape ? static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16)) : text[i];
    if (escape) i += 2;
  }
  return decoded;
}

struct PackageUri {
  std::string package, rest;
};

std::optional<PackageUri> packageUri(const std::string& uri) {
  if (!startsWith(uri, kPackageScheme)) return std::nullopt;
  const std::string path = withoutLeadingSlashes(uri.substr(kPackageScheme.size()));
  const std::size_t slash = std::min(path.find('/'), path.size());
  return PackageUri{percentDecoded(path.substr(0, slash)), withoutLeadingSlashes(path.substr(slash))};
}

// The path of a file:// URI, with or without "localhost". Without a leading slash it is relative: that is what its author meant.
std::string filePath(const std::string& uri) {
  const std::string rest = uri.substr(kFileScheme.size());
  return startsWith(rest, "localhost/") ? rest.substr(rest.find('/')) : rest;
}

// nullopt for an unknown package.
std::optional<fs::path> pathOf(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  if (const auto in_package = packageUri(uri)) {
    const std::optional<std::string> folder = find_package.knownPackage(in_package->package);
    return folder ? std::optional(fs::path(*folder) / in_package->rest) : std::nullopt;
  }
  const bool is_file = startsWith(uri, kFileScheme);
  if (!is_file && uri.find("://") != std::string::npos) {
    throw Error(ErrorCode::kFileNotFound, "'" + uri + "' has a scheme that is not supported; use package://, file:// or a path");
  }
  return fs::path(base).parent_path() / (is_file ? filePath(uri) : uri);  // an absolute path replaces what stands before it
}

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

// Without ".." where that names the same file: behind a symbolic link it may name another. Folders before a ".." need not exist.
std::optional<std::string> existingFile(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  std::error_code error;
  if (isFile(path) && !fs::equivalent(path, normal, error)) return path.string();
  return isFile(normal) ? std::optional(normal.string()) : std::nullopt;
}

std::optional<std::string> nearbyFile(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  const auto in_package = packageUri(uri);
  return in_package ? find_package.fileNearby(in_package->package, in_package->rest, base) : std::nullopt;
}

[[noreturn]] void throwMissing(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  const std::optional<fs::path> path = pathOf(uri, base, find_package);
  if (!path) {
    const std::string package = packageUri(uri)->package;
    throw Error(ErrorCode::kPackageNotFound, "package '" + package + "' of '" + uri +
                                                 "' was not found: install it and source its workspace, or say where it is with " +
                                                 "--package-path " + package + "=DIR (parameter ~package_path of the node)");
  }
  const bool has_no_place = base.empty() && isRelativeUri(uri);
  const std::string file = fs::absolute(*path).lexically_normal().string();
  if (file == uri) throw Error(ErrorCode::kFileNotFound, "'" + uri + "' does not exist; check the path");
  throw Error(ErrorCode::kFileNotFound,
              "'" + uri + "' resolves to '" + file + "', which does not exist" +
                  (has_no_place ? "; it is relative, and the description came without a file name that it could be relative to "
                                  "(parameter ~base of the node)"
                                : "; check the URI or the location of the file"));
}

}  // namespace

std::optional<std::string> packageOf(const std::string& uri) {
  const auto in_package = packageUri(uri);
  return in_package ? std::optional(in_package->package) : std::nullopt;
}

bool isRelativeUri(const std::string& uri) {
  if (startsWith(uri, kFileScheme)) return fs::path(filePath(uri)).is_relative();
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
  if (uri.empty()) throw Error(ErrorCode::kFileNotFound, "a mesh has an empty file name");
  const std::string decoded = percentDecoded(uri);
  for (const std::string& text : {uri, decoded}) {
    const std::optional<fs::path> path = pathOf(text, base, find_package);
    if (const auto file = path ? existingFile(*path) : std::nullopt) return *file;
  }
  for (const std::string& text : {uri, decoded}) {
    if (const auto file = nearbyFile(text, base, find_package)) return *file;
  }
  throwMissing(uri, base, find_package);
}

}  // namespace collision_hulls
