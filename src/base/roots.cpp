// Paths are compared name by name, after links and ".." are resolved. A path may lead elsewhere a moment later, so readers check again what
// they have opened: the kernel tells its real path. One state for the process, since a request reaches files through many readers on many
// threads, and a reader that forgot to pass a state on would be a hole.
#include "base/roots.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>

#include "collision_hulls/error.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

struct State {
  Roots roots;
  std::vector<std::string> packages;  // that turned up so far
};

std::mutex mutex;  // guards `confined`
std::shared_ptr<State> confined;

fs::path real(const fs::path& path) {
  std::error_code error;
  fs::path resolved = fs::weakly_canonical(fs::absolute(path), error);
  if (error) throw Error(ErrorCode::kOutsideRoots, "'" + path.string() + "' cannot be followed: " + error.message() + "; check its links");
  return resolved.has_filename() ? resolved : resolved.parent_path();  // without a slash at its end
}

bool holds(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

bool anyHolds(const std::vector<std::string>& folders, const fs::path& path) {
  return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) { return holds(folder, path); });
}

std::vector<std::string> resolved(const std::vector<std::string>& folders) {
  std::vector<std::string> result;
  for (const std::string& folder : folders)
    if (!folder.empty()) result.push_back(real(folder).string());
  return result;
}

std::shared_ptr<State> state() {
  const std::lock_guard<std::mutex> lock(mutex);
  return confined;
}

bool mayRead(const fs::path& path, const State& state) {
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (anyHolds(state.roots.read, path) || anyHolds(state.packages, path)) return true;
  }
  const std::string package = state.roots.package_with ? state.roots.package_with(path.string()) : "";
  if (package.empty()) return false;
  allowPackage(package);
  return true;
}

[[noreturn]] void fail(const std::string& path, const fs::path& place, const std::vector<std::string>& roots, const std::string& what,
                       const std::string& remedy) {
  std::string list;
  for (const std::string& root : roots) list += (list.empty() ? "'" : ", '") + root + "'";
  throw Error(ErrorCode::kOutsideRoots, "'" + path + "'" + (place == path ? "" : " leads to '" + place.string() + "', which") +
                                            " lies outside of the folders that may be " + what + " (" + (list.empty() ? "none" : list) +
                                            "); " + remedy);
}

/// Where the file lies that was opened under a path.
fs::path placeOf(const std::string& path, int descriptor) {
  std::error_code error;
  fs::path place = fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error);
  if (error) throw Error(ErrorCode::kOutsideRoots, "'" + path + "': /proc, which tells where an open file lies, is missing; mount it");
  return place;
}

void expectReadable(const std::string& path, const fs::path& place, const State& state) {
  if (!mayRead(place, state)) fail(path, place, state.roots.read, "read, and of packages", state.roots.more_read);
}

}  // namespace

Confinement::Confinement(Roots roots) {
  roots.read = resolved(roots.read);
  roots.write = resolved(roots.write);
  roots.outputs = resolved(roots.outputs);
  const std::lock_guard<std::mutex> lock(mutex);
  confined = std::make_shared<State>(State{std::move(roots), {}});
}

Confinement::~Confinement() {
  const std::lock_guard<std::mutex> lock(mutex);
  confined.reset();
}

bool isConfined() {
  return state() != nullptr;
}

bool allowPackage(const std::string& folder) {
  const std::shared_ptr<State> now = state();
  if (!now) return false;
  const std::string package = real(folder).string();
  const std::lock_guard<std::mutex> lock(mutex);
  if (anyHolds(now->packages, package)) return false;
  now->packages.push_back(package);
  return true;
}

void checkRead(const std::string& path) {
  if (const auto now = state()) expectReadable(path, real(path), *now);
}

void checkRead(const std::string& path, int descriptor) {
  if (const auto now = state()) expectReadable(path, placeOf(path, descriptor), *now);
}

bool liesBeside(const std::string& path, int descriptor, const std::string& beside) {
  const fs::path place = placeOf(path, descriptor);
  return holds(real(fs::absolute(beside).parent_path()), place) || holds(real(beside).parent_path(), place);
}

std::string writablePath(const std::string& path) {
  const auto now = state();
  if (!now) return path;
  const fs::path place = real(path);
  const auto below = [&](const std::string& root) { return place != root && holds(root, place); };
  const std::vector<std::string>&roots = now->roots.write, &outputs = now->roots.outputs;
  const bool allowed = std::any_of(roots.begin(), roots.end(), below) || std::find(outputs.begin(), outputs.end(), place) != outputs.end();
  if (!allowed) fail(path, place, roots, "written below", now->roots.more_write);
  return place.string();
}

}  // namespace collision_hulls
