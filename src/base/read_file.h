// Whole files as bytes, which are then hashed and parsed: what is certified is what was hashed.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <string>

#include "base/descriptor.h"
#include "collision_hulls/control.h"

namespace collision_hulls {

/// The content of a regular file. It is opened once, and its kind and size are looked at before a byte is read, so a FIFO, a device or a
/// file that is too large costs nothing. `kind` stands in messages: "mesh". Throws kFileNotFound for what is not there, not a regular file
/// or not readable, and for a file that shrinks meanwhile; kTooLarge above `most_bytes`; kOutsideRoots (roots.h); kCancelled.
std::string readFile(const std::string& path, const std::string& kind, std::uintmax_t most_bytes, const RunControl& control = {});

/// The same, and all that comes through a pipe until its writer closes it: shells make one of `<(xacro robot.srdf.xacro)`. Waits for the
/// writer until the run is cancelled.
std::string readFileOrPipe(const std::string& path, const std::string& kind, std::uintmax_t most_bytes, const RunControl& control);

/// A file that is open for reading, so that what is looked at is what is read.
class OpenFile {
 public:
  enum class Links { kFollow, kRefuse };

  /// Never waits, not even for a FIFO. Check error().
  explicit OpenFile(const std::string& path, Links links = Links::kFollow);

  int error() const { return error_; }  ///< 0, or the errno that says why the file is not open
  const struct stat& status() const { return status_; }
  int number() const { return descriptor_.number(); }  ///< the file descriptor

  /// Throws kOutsideRoots (roots.h).
  void expectAllowed() const;

  /// See readFile(), which throws the same apart from kOutsideRoots.
  std::string content(const std::string& kind, std::uintmax_t most_bytes, const RunControl& control = {}) const;
  /// See readFileOrPipe().
  std::string contentOfPipe(const std::string& kind, std::uintmax_t most_bytes, const RunControl& control) const;

  /// Throws kFileNotFound unless it is an open regular file.
  void expectRegular(const std::string& kind) const;

 private:
  const std::string path_;
  const Descriptor descriptor_;
  int error_ = 0;
  struct stat status_ {};
};

}  // namespace collision_hulls
