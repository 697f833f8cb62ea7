// The files that the URIs of a description mean.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
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

// "%20" and its like as the bytes that they stand for; a '%' without two digits stays.
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

fs::path packagePath(const std::string& uri, const PackageFinder& find_package) {
  const std::string rest = withoutLeadingSlashes(uri.substr(kPackageScheme.size()));
  const std::size_t slash = std::min(rest.find('/'), rest.size());
  const std::string package = percentDecoded(rest.substr(0, slash));
  const std::optional<std::string> folder = find_package ? find_package(package) : std::nullopt;
  if (!folder) {
    throw Error(ErrorCode::kPackageNotFound, "package '" + package + "' of '" + uri +
                                                 "' is not found: add the folder that holds it to ROS_PACKAGE_PATH, or source the "
                                                 "setup.bash of its workspace");
  }
  return fs::path(*folder) / withoutLeadingSlashes(rest.substr(slash));
}

// The path of file://, with or without the name of this machine. One without a leading slash is taken as relative, as it is meant.
std::string filePath(const std::string& uri) {
  const std::string rest = uri.substr(kFileScheme.size());
  return startsWith(rest, "localhost/") ? rest.substr(rest.find('/')) : rest;
}

fs::path pathOf(const std::string& uri, const std::string& base, const PackageFinder& find_package) {
  if (startsWith(uri, kPackageScheme)) return packagePath(uri, find_package);
  const bool is_file = startsWith(uri, kFileScheme);
  if (!is_file && uri.find("://") != std::string::npos) {
    throw Error(ErrorCode::kFileNotFound, "'" + uri + "': this scheme is not read; use package://, file:// or a path");
  }
  return fs::path(base).parent_path() / (is_file ? filePath(uri) : uri);  // an absolute path replaces what stands before it
}

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

}  // namespace

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
  const fs::path path = pathOf(uri, base, find_package);
  // Without ".." where that is the same file; behind a link it may not be.
  for (const fs::path& file : {path, pathOf(percentDecoded(uri), base, find_package)})
    for (const fs::path& name : {file.lexically_normal(), file})
      if (isFile(name)) return name.string();
  const bool has_no_place = base.empty() && isRelativeUri(uri);
  throw Error(
      ErrorCode::kFileNotFound,
      "'" + uri + "' means '" + path.lexically_normal().string() + "', and there is no such file" +
          (has_no_place ? "; it is relative, and the description came without a file that it is relative to (the node's is ~base)" : ""));
}

}  // namespace collision_hulls
