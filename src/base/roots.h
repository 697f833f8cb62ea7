// The folders outside of which a process neither reads nor writes, when it works for people whom it does not trust.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace collision_hulls {

struct Roots {
  std::vector<std::string> read, write;  ///< folders; what is written lies below one of them and is none of them
  std::vector<std::string> outputs;      ///< folders that may be written although they lie elsewhere
  /// The folder of the package that a path, without links, lies in, or "": it may be read as well. Empty: there are no packages.
  std::function<std::string(const std::string& path)> package_with;
  std::string more_read, more_write;  ///< the remedies in messages: "set ~read_roots to a list that has it"
};

/// Confines the whole process for as long as it lives: what is confined is what a request can reach, on whichever thread. One at a time.
class Confinement {
 public:
  explicit Confinement(Roots roots);
  ~Confinement();
  Confinement(const Confinement&) = delete;
  Confinement& operator=(const Confinement&) = delete;
};

bool isConfined();

/// Lets a confined process read a folder that turned out to be a package's; whether that is news. Without confinement it does nothing, nor
/// do the checks below.
bool allowPackage(const std::string& folder);

/// Throws kOutsideRoots where a path, all links resolved, may not be read.
void checkRead(const std::string& path);

/// The same for a file that was opened under that path: what a link led to then is what counts.
void checkRead(const std::string& path, int descriptor);

/// Whether a file that was opened under `path` lies in the folder of another or below it, all links resolved: in that by which `beside` is
/// named, or that where it is.
bool liesBeside(const std::string& path, int descriptor, const std::string& beside);

/// The path of what is to be written, its links resolved, so that a link that changes later changes nothing. Throws kOutsideRoots.
std::string writablePath(const std::string& path);

}  // namespace collision_hulls
